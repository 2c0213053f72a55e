// SPDX-License-Identifier: GPL-3.0-or-later
// Commands: pure functions from a document and a wish to the delta that fulfils it, or to an error that says why not.
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"

namespace mes {

/// Adds samples at the given positions, in that order. Error: a coordinate that is not finite.
Expected<DocumentDelta> insert_samples(const Document& document, std::span<const Vec2> positions);

/// Removes live samples. Error: an id that is not alive, or one named twice.
Expected<DocumentDelta> remove_samples(const Document& document, std::span<const SampleId> ids);

/// Moves live samples to new positions. Error: an id that is not alive or named twice, a coordinate that is not
/// finite.
Expected<DocumentDelta> move_samples(const Document& document, std::span<const std::pair<SampleId, Vec2>> targets);

/// Adds balls, in that order. Error: a number that is not finite, a negative radius.
Expected<DocumentDelta> insert_balls(const Document& document, std::span<const Disk> disks);

/// Removes live balls. Error: an id that is not alive, or one named twice.
Expected<DocumentDelta> remove_balls(const Document& document, std::span<const BallId> ids);

/// Gives live balls new centres and radii. Error: an id that is not alive or named twice, a number that is not
/// finite, a negative radius.
Expected<DocumentDelta> change_balls(const Document& document, std::span<const std::pair<BallId, Disk>> targets);

/// A delta of samples and one of balls, both of the same document state, as one: a gesture that takes both along then
/// stays one delta, however long it lasts.
Expected<DocumentDelta> together(Expected<DocumentDelta> samples, const Expected<DocumentDelta>& balls);

/// Data to replace a document with, e.g. the contents of a file.
struct SampleData {
  struct Contour {
    bool closed = true;
    std::vector<std::uint32_t> points;  ///< indices into `positions`
    friend bool operator==(const Contour&, const Contour&) = default;
  };
  std::vector<Vec2> positions{};
  std::vector<Contour> contours{};
  std::vector<Disk> balls{};
};

/// Moves the live samples, in input order, to the first of `positions`, and adds samples at the others. `contours`,
/// if any, become the curve order; they name samples by their place in `positions`. Error: fewer positions than
/// samples, otherwise as when samples are moved, inserted and replaced.
Expected<DocumentDelta> arrange_samples(const Document& document, std::span<const Vec2> positions,
                                        std::span<const SampleData::Contour> contours);

/// Replaces all samples, the curve order and all balls. New ids. Error: as when samples and balls are inserted, an
/// index out of range.
Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data);

}  // namespace mes

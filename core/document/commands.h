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

/// Data to replace a document with, e.g. the contents of a file.
struct SampleData {
  struct Contour {
    bool closed = true;
    std::vector<std::uint32_t> points;  ///< indices into `positions`
  };
  std::vector<Vec2> positions;
  std::vector<Contour> contours;
};

/// Replaces all samples and the curve order. New ids. Error: a coordinate that is not finite, an index out of range.
Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Commands: pure functions from a document and a wish to the delta that fulfils it, or to an error that says why not.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"
#include "core/document/map_plane.h"

namespace mes {

/// What is to happen in one delta. Samples are not removed and others moved in one, balls not removed together with
/// other changes of balls.
struct DocumentChange {
  std::span<const SampleId> removed{};  ///< before others are inserted
  std::span<const std::pair<SampleId, Vec2>> moved{};
  std::span<const Vec2> inserted{};  ///< in that order
  std::span<const BallId> removed_balls{};
  std::span<const std::pair<BallId, Disk>> changed_balls{};
  std::span<const Disk> inserted_balls{};
};

/// Error: an id that is not alive, or one named twice; a number outside the range of coordinates, by itself or beside
/// the others that the document then has; a negative radius. A change that moves everything to numbers of another
/// size is judged as a whole.
Expected<DocumentDelta> change_document(const Document& document, const DocumentChange& change);

// One kind of change each; errors as above.
inline Expected<DocumentDelta> insert_samples(const Document& document, std::span<const Vec2> positions) {
  return change_document(document, {.inserted = positions});
}
inline Expected<DocumentDelta> remove_samples(const Document& document, std::span<const SampleId> ids) {
  return change_document(document, {.removed = ids});
}
inline Expected<DocumentDelta> move_samples(const Document& document,
                                            std::span<const std::pair<SampleId, Vec2>> targets) {
  return change_document(document, {.moved = targets});
}
inline Expected<DocumentDelta> insert_balls(const Document& document, std::span<const Disk> disks) {
  return change_document(document, {.inserted_balls = disks});
}
inline Expected<DocumentDelta> remove_balls(const Document& document, std::span<const BallId> ids) {
  return change_document(document, {.removed_balls = ids});
}
/// Gives balls new centres and radii.
inline Expected<DocumentDelta> change_balls(const Document& document,
                                            std::span<const std::pair<BallId, Disk>> targets) {
  return change_document(document, {.changed_balls = targets});
}

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
  Annotations annotations{};                    ///< samples by their place in `positions`
  std::shared_ptr<const CurveSource> source{};  ///< curves that samples were taken from; null: none
  std::optional<MapPlane> map{};                ///< where on the Earth they lie; none: they were no map in degrees
};

/// Makes these the annotations. Error: what `fault_of` says of them.
Expected<DocumentDelta> annotate(const Document& document, Annotations annotations);

/// All of the document: samples and balls in input order. `replace_all` makes it again, with other ids. O(n log n).
SampleData data_of(const Document& document);

/// Replaces the contours, which may name samples that were removed. Error: `bad_input` for a sample that never was.
Expected<DocumentDelta> set_contours(const Document& document, CurveOrder contours);

/// Moves the live samples, in input order, to the first of `positions`, and adds samples at the others. `contours`,
/// if any, become the curve order; they name samples by their place in `positions`. Error: fewer positions than
/// samples, otherwise as when samples are moved, inserted and replaced.
Expected<DocumentDelta> arrange_samples(const Document& document, std::span<const Vec2> positions,
                                        std::span<const SampleData::Contour> contours);

/// Takes away what is left of the samples that were taken from the document's curves, and adds those of `data` with
/// their contours; others stay. Curves to take samples from are those of `data` afterwards, or none. Balls and
/// annotations of `data` are passed over. Error: as when samples are inserted; an index out of range.
Expected<DocumentDelta> resample(const Document& document, const SampleData& data);

/// Replaces all samples, the curve order, the curves, all balls, all annotations, and where on the Earth they lie. New ids. Error: as when samples and balls are
/// inserted, an index out of range, what `fault_of` says of annotations.
Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Commands: pure functions from a document and a requested change to a delta, or to an error that explains the refusal.
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"
#include "core/document/sample_data.h"

namespace mes {

/// The parts of one delta. A delta cannot both remove and move samples, nor combine removals of balls with other
/// changes of balls.
struct DocumentChange {
  std::span<const SampleId> removed{};  ///< applied before insertions
  std::span<const std::pair<SampleId, Vec2>> moved{};
  std::span<const Vec2> inserted{};  ///< in this order
  std::span<const BallId> removed_balls{};
  std::span<const std::pair<BallId, Disk>> changed_balls{};
  std::span<const Disk> inserted_balls{};
};

/// Error: an id that is not alive or is listed twice; a number outside the range of coordinates, by itself or together
/// with the other numbers of the resulting document; a negative radius. A change that rescales everything is judged by
/// its result.
Expected<DocumentDelta> change_document(const Document& document, const DocumentChange& change);

// Shortcuts for one kind of change each; errors as above.
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
/// Sets new centres and radii of balls.
inline Expected<DocumentDelta> change_balls(const Document& document,
                                            std::span<const std::pair<BallId, Disk>> targets) {
  return change_document(document, {.changed_balls = targets});
}

/// Replaces the annotations. Error: the fault that `fault_of` reports.
Expected<DocumentDelta> annotate(const Document& document, Annotations annotations);

/// The whole document: samples and balls in input order. `replace_all` recreates it, with other ids. O(n log n).
SampleData data_of(const Document& document);

/// Replaces the contours, which may name removed samples. Error: `bad_input` for a sample that never existed.
Expected<DocumentDelta> set_contours(const Document& document, CurveOrder contours);

/// Replaces the curves that samples were taken from, and how they were taken; null: none from now on. No sample moves.
DocumentDelta set_source(const Document& document, std::shared_ptr<const CurveSource> source);

/// Moves the live samples, in input order, to the first of `positions`, and inserts samples at the others. `contours`,
/// if not empty, become the curve order; they name samples by index in `positions`. Error: fewer positions than
/// samples, otherwise as for moves, insertions and replacements.
Expected<DocumentDelta> arrange_samples(const Document& document, std::span<const Vec2> positions,
                                        std::span<const SampleData::Contour> contours);

/// Replaces the remaining samples of the document's curves by the samples of `data` with their contours; other samples
/// stay. The curve source becomes that of `data`, or none. Balls and annotations of `data` are ignored. Error: as for
/// insertions; an index out of range.
Expected<DocumentDelta> resample(const Document& document, const SampleData& data);

/// Replaces all content: samples, curve order, curves, balls, annotations and map plane. Ids are new. Error: as for
/// insertions of samples and balls, an index out of range, and faults that `fault_of` reports for annotations.
Expected<DocumentDelta> replace_all(const Document& document, const SampleData& data);

}  // namespace mes

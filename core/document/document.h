// SPDX-License-Identifier: GPL-3.0-or-later
// The persistent state of the program: samples and balls with stable ids, the curve order of the samples, the curves
// that samples were taken from, and annotations.
//
// Guarantees:
//  1. An id names the same sample (or ball) for the whole session, through undo and redo, and is never reused.
//  2. A slot is stable while its sample (ball) lives. Several samples may share one position, several balls one disk;
//     each keeps its own record.
//  3. Numbers are within the range of coordinates (core/base/geometry/coordinate_range.h), each alone and all together, and
//     never -0.0; radii are not negative. A ball may have radius zero.
//  4. Commands (commands.h) compute a delta and change nothing; only `apply` changes the document. A delta that
//     does not fit the present revision is refused by an assertion, never half applied.
//  5. Undo restores everything, including free rows, so that redo finds the state in which it was recorded.
//
// Smallest use:
//     Document document;
//     if (auto delta = insert_samples(document, points)) document.apply(*delta);
//
// Cost: `apply` is O(edits). Threads: none; the window's thread owns it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/document/delta.h"
#include "core/document/rows.h"

namespace mes {

class Document {
 public:
  Document();
  /// An empty document whose revisions and ids continue from this one, so that no delta of one fits the other.
  Document successor() const;
  /// Ensures that future changes of this document get revisions that the other one never had.
  void number_after(const Document& other) {
    highest_revision_ = std::max(highest_revision_, other.highest_revision_);
  }

  std::uint64_t revision() const { return revision_; }
  std::size_t sample_count() const { return samples_.count(); }
  /// Number of rows, in use or free; `is_alive` tells which.
  std::size_t slot_count() const { return samples_.row_count(); }
  bool is_alive(SampleSlot slot) const { return samples_.is_alive(slot); }
  Vec2 position(SampleSlot slot) const { return samples_.value(slot); }
  SampleId id(SampleSlot slot) const { return samples_.id(slot); }
  const Table<SampleSlot, Vec2>& positions() const { return samples_.values(); }
  const Table<SampleSlot, SampleId>& ids() const { return samples_.ids(); }
  /// Row of a live sample, or kNoSlot.
  SampleSlot slot_of(SampleId id) const { return samples_.slot_of(id); }
  /// Live slots by increasing id, which is the input order. O(n log n).
  std::vector<SampleSlot> slots_in_input_order() const { return samples_.by_age(); }
  const std::shared_ptr<const CurveOrder>& curve_order() const { return curve_; }
  /// Never null; equal pointers mean that nothing changed.
  const std::shared_ptr<const Annotations>& annotations() const { return annotations_; }
  /// Null if samples were not taken from curves.
  const std::shared_ptr<const CurveSource>& source() const { return source_; }
  /// Position of the plane on the Earth, for data from a map. Only a replacement of everything changes it.
  const std::optional<MapPlane>& map() const { return map_; }
  /// The remaining samples of the source curves, by increasing id. O(samples ever taken from them).
  std::vector<SampleId> samples_of_source() const;
  /// Present position of the anchor. If the followed position does not exist, as for the circle of three collinear
  /// samples, this is the position where the anchor was set.
  Vec2 place_of(const Anchor& anchor) const;
  /// The unit for radii about the anchor: see `HighlightedElement`.
  double radius_unit(const Anchor& anchor) const;
  /// Numbers of samples and balls that exist or existed since the last complete replacement.
  NumberedThings numbered_things() const {
    return {next_id().value - first_id().value, next_ball_id().value - first_ball_id().value};
  }

  /// Id of the first sample since the last complete replacement. Numbers relative to it are the same, however often the
  /// data were opened before.
  SampleId first_id() const { return SampleId{samples_.first_id()}; }
  BallId first_ball_id() const { return BallId{balls_.first_id()}; }

  /// The same for balls, which have rows of their own.
  std::size_t ball_count() const { return balls_.count(); }
  std::size_t ball_slot_count() const { return balls_.row_count(); }
  bool is_ball_alive(BallSlot slot) const { return balls_.is_alive(slot); }
  const Disk& disk(BallSlot slot) const { return balls_.value(slot); }
  BallId ball_id(BallSlot slot) const { return balls_.id(slot); }
  BallSlot ball_slot_of(BallId id) const { return balls_.slot_of(id); }
  std::vector<BallSlot> ball_slots_in_input_order() const { return balls_.by_age(); }

  /// True without samples and balls.
  bool is_empty() const { return sample_count() == 0 && ball_count() == 0; }
  /// Bounding box of samples, balls, and fixed anchors of annotations; finite. O(n).
  Box2 bounding_box() const;
  /// Order-independent digest of ids (relative to the first), positions and disks. Equal edits of equal data give equal
  /// digests, whatever was open before. O(1): `apply` keeps the sums up to date.
  std::uint64_t digest() const { return sample_digest() + ball_digest(); }
  std::uint64_t sample_digest() const;
  /// Zero when there are no balls.
  std::uint64_t ball_digest() const;

  /// Magnitudes of all coordinates and radii.
  Magnitudes magnitudes() const { return magnitudes_.magnitudes(); }
  /// Magnitudes after the delta. They may include removed numbers, if all fit. Each number must be in range by itself.
  /// O(edits).
  Magnitudes magnitudes_after(const DocumentDelta& delta) const;

  /// Changes the document. `delta.from_revision` must be the present revision, and the magnitudes after it must fit.
  /// Throws and changes nothing if memory runs out.
  void apply(const DocumentDelta& delta);
  /// Reserves memory, so that applying the deltas in order allocates nothing. None may replace everything.
  void make_room_for(std::span<const DocumentDelta> deltas);

  // For commands.
  SampleId next_id() const { return SampleId{samples_.next_id()}; }
  BallId next_ball_id() const { return BallId{balls_.next_id()}; }
  SampleSlot slot_for_new_sample(std::size_t i) const { return samples_.slot_for_new(i); }
  BallSlot slot_for_new_ball(std::size_t i) const { return balls_.slot_for_new(i); }
  std::uint64_t next_revision() const { return highest_revision_ + 1; }
  std::shared_ptr<const SampleSnapshot> snapshot() const;
  std::shared_ptr<const BallSnapshot> ball_snapshot() const;

 private:
  /// The followed balls, with scaled radii; nothing if the anchor follows none, or if one is not alive.
  std::optional<std::array<Disk, 4>> followed_disks(const Anchor& anchor) const;
  Vec2 place_by_balls(const Anchor& anchor) const;
  std::uint64_t digest_of_sample(SampleSlot slot) const;
  std::uint64_t digest_of_ball(BallSlot slot) const;
  void replace_all(const DocumentDelta& delta);
  void apply(const SampleEdit& edit);
  void apply(const BallEdit& edit);

  Rows<Vec2, SampleTag> samples_;
  Rows<Disk, BallTag> balls_;
  MagnitudeCounts magnitudes_;
  std::shared_ptr<const CurveOrder> curve_;
  std::shared_ptr<const Annotations> annotations_;
  std::shared_ptr<const CurveSource> source_;
  std::optional<MapPlane> map_;
  std::uint64_t revision_ = 0;
  std::uint64_t highest_revision_ = 0;
  std::uint64_t sample_sum_ = 0;  // sum of the digests of all samples
  std::uint64_t ball_sum_ = 0;
};

}  // namespace mes

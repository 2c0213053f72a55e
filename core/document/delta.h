// SPDX-License-Identifier: GPL-3.0-or-later
// The change from one document state to another, used by the engine, the history and the journal.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/base/slot.h"
#include "core/base/table.h"
#include "core/document/annotation.h"
#include "core/document/map_plane.h"

namespace mes {

struct CurveSource;

/// Known curves through the samples, from a file or a generator. Readers skip ids that are no longer alive, so neither
/// a removal of a sample nor its undo changes this list.
struct CurveOrder {
  struct Contour {
    bool closed = true;
    std::vector<SampleId> samples;
    friend bool operator==(const Contour&, const Contour&) = default;
  };
  std::vector<Contour> contours;
  friend bool operator==(const CurveOrder&, const CurveOrder&) = default;
};

struct SampleEdit {
  enum class Kind : std::uint8_t { insert, remove, move };
  Kind kind = Kind::insert;
  SampleId id;
  SampleSlot slot;  ///< row of the sample; rows of removed samples are reused
  Vec2 from;        ///< before (remove, move)
  Vec2 to;          ///< after (insert, move)
};

/// A complete set of samples. Shared, and never modified after its creation.
struct SampleSnapshot {
  Table<SampleSlot, Vec2> position;  ///< dead rows hold (0, 0)
  Table<SampleSlot, SampleId> id;    ///< invalid in dead rows
  std::vector<SampleSlot> free_slots;
  SampleId first{0};  ///< id of the first sample of the data, alive or not
  std::optional<MapPlane> map{};
};

/// One change of a user's ball. Kinds as for samples; `change` sets centre and radius.
struct BallEdit {
  enum class Kind : std::uint8_t { insert, remove, change };
  Kind kind = Kind::insert;
  BallId id;
  BallSlot slot;  ///< row of the ball; rows of removed balls are reused
  Disk from;      ///< before (remove, change)
  Disk to;        ///< after (insert, change)
};

/// Like `SampleSnapshot`, for balls.
struct BallSnapshot {
  Table<BallSlot, Disk> disk;  ///< dead rows hold a zero disk
  Table<BallSlot, BallId> id;  ///< invalid in dead rows
  std::vector<BallSlot> free_slots;
  BallId first{0};
};

/// Applied in order. Holds either `edits`, or a replacement of everything if `after` is set.
struct DocumentDelta {
  std::uint64_t from_revision = 0;
  std::uint64_t to_revision = 0;
  std::vector<SampleEdit> edits;
  std::shared_ptr<const SampleSnapshot> before;  ///< set together with `after`
  std::shared_ptr<const SampleSnapshot> after;
  std::vector<BallEdit> ball_edits;
  /// Set together; every replacement of the samples replaces the balls as well.
  std::shared_ptr<const BallSnapshot> balls_before;
  std::shared_ptr<const BallSnapshot> balls_after;
  std::shared_ptr<const CurveOrder> curve_before;  ///< equal to `curve_after` when the order does not change
  std::shared_ptr<const CurveOrder> curve_after;
  std::shared_ptr<const Annotations> annotations_before;  ///< equal to `annotations_after` when they do not change
  std::shared_ptr<const Annotations> annotations_after;
  std::shared_ptr<const CurveSource> source_before;  ///< equal to `source_after` when it does not change; null: none
  std::shared_ptr<const CurveSource> source_after;

  bool replaces_all() const { return after != nullptr; }
  bool changes_annotations() const { return annotations_before != annotations_after; }
  bool changes_source() const { return source_before != source_after; }
  bool is_empty() const {
    return !replaces_all() && edits.empty() && ball_edits.empty() && curve_before == curve_after &&
           !changes_annotations() && !changes_source();
  }
  /// The inverse delta, which undoes this one.
  DocumentDelta inverted() const;
};

template <class Visit>
void for_each_number(Vec2 p, Visit visit) {
  visit(p.x);
  visit(p.y);
}
template <class Visit>
void for_each_number(const Disk& disk, Visit visit) {
  for_each_number(disk.center, visit);
  visit(disk.radius);
}
/// Calls `visit(x)` for each new coordinate and radius, in order.
template <class Visit>
void for_each_new_number(const DocumentDelta& delta, Visit visit) {
  if (delta.replaces_all()) {
    for (const Vec2 p : delta.after->position) for_each_number(p, visit);
    for (const Disk& disk : delta.balls_after->disk) for_each_number(disk, visit);
  }
  for (const SampleEdit& edit : delta.edits)
    if (edit.kind != SampleEdit::Kind::remove) for_each_number(edit.to, visit);
  for (const BallEdit& edit : delta.ball_edits)
    if (edit.kind != BallEdit::Kind::remove) for_each_number(edit.to, visit);
}

/// Combines several deltas into one. None may replace everything, and each must begin where the one before ends; there
/// must be at least one.
DocumentDelta one_after_the_other(std::span<const DocumentDelta> deltas);

}  // namespace mes

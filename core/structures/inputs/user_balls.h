// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's own copy of the document's balls, row for row.
#pragma once

#include <memory>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/disk.h"
#include "core/graph/source_structure.h"

namespace mes {

/// A source beside `Samples`: `post` queues deltas; the next run applies them all as one change. A ball of radius zero
/// has a row like any other; consumers decide how it counts.
class UserBalls final : public SourceStructure {
 public:
  UserBalls() : SourceStructure("balls") {}

  /// Deltas that do not touch balls are dropped: an edit of a sample costs nothing here.
  void post(std::shared_ptr<const DocumentDelta> delta) override;
  bool has_pending() const override { return !pending_.empty(); }

  /// Number of rows, indexed by the document's slots.
  std::size_t row_count() const { return disk_.size(); }
  bool is_alive(BallSlot slot) const { return id_.has(slot) && id_[slot].is_valid(); }
  const Disk& disk(BallSlot slot) const { return disk_[slot]; }
  BallId id(BallSlot slot) const { return id_[slot]; }
  std::size_t count() const { return count_; }
  Box2 extent() const override { return extent_; }

  const ChangeSet<BallSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  void make_room();
  void apply(const DocumentDelta& delta);

  std::vector<std::shared_ptr<const DocumentDelta>> pending_;
  Table<BallSlot, Disk> disk_;
  Table<BallSlot, BallId> id_;
  std::size_t count_ = 0;
  Box2 extent_;
  ChangeRecorder<BallSlot> recorder_;
  ChangeSet<BallSlot> changes_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's own copy of the document's samples, row for row.
#pragma once

#include <memory>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/box2.h"
#include "core/document/delta.h"
#include "core/graph/source_structure.h"

namespace mes {

/// The root of the graph. `post` queues deltas; the next run applies them all as one change.
class Samples final : public SourceStructure {
 public:
  Samples();

  void post(std::shared_ptr<const DocumentDelta> delta) override { pending_.push_back(std::move(delta)); }
  bool has_pending() const override { return !pending_.empty(); }

  /// Number of rows, indexed by the document's slots.
  std::size_t row_count() const { return position_.size(); }
  bool is_alive(SampleSlot slot) const { return id_.has(slot) && id_[slot].is_valid(); }
  Vec2 position(SampleSlot slot) const { return position_[slot]; }
  SampleId id(SampleSlot slot) const { return id_[slot]; }
  std::size_t count() const { return count_; }
  /// Never null; the same pointer as long as no contour changes.
  const std::shared_ptr<const CurveOrder>& curve_order_shared() const { return curve_; }
  std::uint64_t document_revision() const { return document_revision_; }
  Box2 extent() const override { return extent_; }

  const ChangeSet<SampleSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {
    changes_.clear();
    has_other_contours_ = false;
  }
  /// A change of contours counts as one.
  std::size_t touched() const override { return changes_.size() + (has_other_contours_ ? 1 : 0); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  void make_room();
  void apply(const DocumentDelta& delta);

  std::vector<std::shared_ptr<const DocumentDelta>> pending_;
  Table<SampleSlot, Vec2> position_;
  Table<SampleSlot, SampleId> id_;
  std::shared_ptr<const CurveOrder> curve_;
  std::size_t count_ = 0;
  bool has_other_contours_ = false;  // contours differ from those before the last run
  std::uint64_t document_revision_ = 0;
  Box2 extent_;
  ChangeRecorder<SampleSlot> recorder_;
  ChangeSet<SampleSlot> changes_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The persistent state of the program: samples with stable ids, and the known order of their curve.
//
// What it guarantees:
//  1. An id names the same sample for the whole session, through undo and redo, and is never given twice.
//  2. A slot is stable while its sample lives. Several samples may share one position; each keeps its own record.
//  3. Positions are finite, and never -0.0.
//  4. Commands (commands.h) compute a delta and change nothing; only `apply` changes the document. A delta that
//     does not fit the present revision is refused by an assertion, never half applied.
//  5. Undo restores everything, free rows included, so that redo meets the state it was recorded in.
//
// Smallest use:
//     Document document;
//     if (auto delta = insert_samples(document, points)) document.apply(*delta);
//
// Cost: `apply` is O(edits). Threads: none; the window's thread owns it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/box2.h"
#include "core/document/delta.h"

namespace mes {

class Document {
 public:
  Document();

  std::uint64_t revision() const { return revision_; }
  std::size_t sample_count() const { return alive_; }
  /// Rows in use or free; `is_alive` tells which.
  std::size_t slot_count() const { return position_.size(); }
  bool is_alive(Slot slot) const { return slot < id_.size() && id_[slot].is_valid(); }
  Vec2 position(Slot slot) const { return position_[slot]; }
  SampleId id(Slot slot) const { return id_[slot]; }
  std::span<const Vec2> positions() const { return position_; }
  std::span<const SampleId> ids() const { return id_; }
  /// Row of a live sample, or kNoSlot.
  Slot slot_of(SampleId id) const;
  /// Live slots by increasing id, which is input order. O(n log n).
  std::vector<Slot> slots_in_input_order() const;
  const std::shared_ptr<const CurveOrder>& curve_order() const { return curve_; }
  /// Bounding box of the samples, O(n).
  Box2 bounding_box() const;
  /// Order-independent digest of ids and positions; equal documents have equal digests.
  std::uint64_t digest() const;

  /// Changes the document. `delta.from_revision` must be the present revision.
  void apply(const DocumentDelta& delta);

  // For commands.
  SampleId next_id() const { return SampleId{next_id_}; }
  std::span<const Slot> free_slots() const { return free_; }
  std::uint64_t next_revision() const { return highest_revision_ + 1; }
  std::shared_ptr<const SampleSnapshot> snapshot() const;

 private:
  void insert(const SampleEdit& edit);
  void remove(const SampleEdit& edit);

  std::vector<Vec2> position_;
  std::vector<SampleId> id_;
  std::vector<Slot> free_;  // a stack: undo gives rows back in the reverse order of taking them
  std::unordered_map<SampleId, Slot> slot_of_;
  std::shared_ptr<const CurveOrder> curve_;
  std::size_t alive_ = 0;
  std::uint32_t next_id_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t highest_revision_ = 0;
};

}  // namespace mes

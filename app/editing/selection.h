// SPDX-License-Identifier: GPL-3.0-or-later
// The set of selected samples and balls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace mes {

/// Guarantees: only live samples and balls are selected; removed ones leave the selection, and return unselected when
/// the removal is undone. Cost: O(1) per change, O(rows) for the whole-set operations. Threads: none; it follows the
/// document of the window's thread.
class Selection {
 public:
  /// Number of samples and balls together.
  std::size_t size() const { return samples_.count + balls_.count; }
  bool is_empty() const { return size() == 0; }
  /// Grows with every change; equal numbers mean an equal selection.
  std::uint64_t revision() const { return revision_; }

  /// Samples, by row.
  bool contains(SampleSlot slot) const { return samples_.contains(slot); }
  void add(SampleSlot slot) { note(samples_.add(slot)); }
  void remove(SampleSlot slot) { note(samples_.remove(slot)); }
  std::size_t sample_count() const { return samples_.count; }
  /// Rows in increasing order. O(rows).
  std::vector<SampleSlot> slots() const { return samples_.slots(); }

  /// Balls, by row.
  bool contains_ball(BallSlot slot) const { return balls_.contains(slot); }
  void add_ball(BallSlot slot) { note(balls_.add(slot)); }
  void remove_ball(BallSlot slot) { note(balls_.remove(slot)); }
  std::size_t ball_count() const { return balls_.count; }
  std::vector<BallSlot> ball_slots() const { return balls_.slots(); }

  void clear();
  void select_all(const Document& document);
  void invert(const Document& document);

  /// Call it after `document.apply(delta)`.
  void follow(const DocumentDelta& delta);

 private:
  template <class Row>
  struct Mask {
    Table<Row, std::uint8_t> bits;
    std::size_t count = 0;

    bool contains(Row slot) const { return bits.has(slot) && bits[slot] != 0; }
    bool add(Row slot);
    bool remove(Row slot);
    void clear();
    std::vector<Row> slots() const;
  };
  void note(bool changed) { revision_ += changed ? 1U : 0U; }

  Mask<SampleSlot> samples_;
  Mask<BallSlot> balls_;
  std::uint64_t revision_ = 0;
};

/// "1 sample", "3 balls", "12 samples and 1 ball"; "nothing" when both are zero.
std::string counted(std::size_t samples, std::size_t balls);

/// A noun for the selection in the name of a step: "sample", "samples", "ball", "samples and balls", ...
std::string noun_of(const Selection& selection);

}  // namespace mes

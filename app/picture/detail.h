// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a heavy drawing is painted, so that the window stays quick on any graphics card.
#pragma once

#include <cstdint>

namespace mes {

/// Disks are what can make a picture slow: a million large ones lie on each other a thousandfold. While the picture
/// moves only each `every()`-th is painted; once it rests, more and more of them, as long as that stays short.
///
/// What it guarantees:
///  1. The share is a power of two; one frame that was too slow is followed by one that is not.
///  2. It ends: after `is_refining()` is false the same picture need not be painted again.
///
/// Smallest use:
///     paint(detail.begin_changed(disks)); detail.painted(ms);
///     while (detail.is_refining()) { paint(detail.begin_refinement()); detail.painted(ms); }
///
/// Threads: none. It knows no clock: the caller measures.
class Detail {
 public:
  /// For a picture that is new; `disks` is the number of them in the largest layer.
  std::uint32_t begin_changed(std::uint32_t disks);
  /// For the same picture once more.
  std::uint32_t begin_refinement();
  void painted(double milliseconds);
  bool is_refining() const { return is_refining_; }
  /// 1: everything is painted.
  std::uint32_t every() const { return every_; }

 private:
  std::uint32_t every_ = 1;
  std::uint32_t every_moving_ = 1;
  std::uint32_t disks_ = 0;
  bool is_refinement_ = false;
  bool is_refining_ = false;
};

}  // namespace mes

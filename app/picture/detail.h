// SPDX-License-Identifier: GPL-3.0-or-later
// Reduces the detail of heavy drawings, so that the window responds quickly with any graphics card.
#pragma once

#include <cstdint>

namespace mes {

/// Disks that are painted can make a picture slow: of a million large ones, a thousand may cover each pixel. While the
/// picture moves, one of `every()` disks is painted; when it rests, more and more of them, as long as a frame stays
/// short. A frame may be long because other programs are busy, so the same is painted again before refinement gives up.
///
/// Guarantees:
///  1. `every()` is a power of two, and a frame that took too long is followed by a shorter one.
///  2. Refinement ends: once `is_refining()` is false, the same picture need not be painted again.
///
/// Smallest use:
///     paint(detail.begin_changed(disks)); detail.painted(ms);
///     while (detail.is_refining()) { paint(detail.begin_refinement()); detail.painted(ms); }
///
/// The caller measures the time. Threads: a value; one at a time.
class Detail {
 public:
  /// Begins a picture that has changed; `disks` is the number of disks in the layer that has most of them to paint;
  /// those that are counted (render/instances/counted_instances.h) cost little and are left out.
  std::uint32_t begin_changed(std::uint32_t disks);
  /// Begins the same picture again, in more detail.
  std::uint32_t begin_refinement();
  void painted(double milliseconds);
  bool is_refining() const { return is_refining_; }
  /// 1: all disks are painted.
  std::uint32_t every() const { return every_; }

 private:
  std::uint32_t every_ = 1;
  std::uint32_t every_moving_ = 1;
  std::uint32_t disks_ = 0;
  bool is_refinement_ = false;
  bool is_refining_ = false;
  int long_frames_ = 0;  ///< consecutive long frames at rest
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/detail.h"

#include <algorithm>
#include <bit>

namespace mes {
namespace {

constexpr double kMovingMs = 60.0;        // limit for a frame while the picture moves; longer frames look jerky
constexpr double kRestingMs = 300.0;      // limit for a frame at rest; longer frames delay the next input too much
constexpr int kLongFrames = 3;            // consecutive long frames at rest after which refinement stops
constexpr std::uint32_t kAlways = 256;    // disks that are always painted: they show the shape of the union
constexpr std::uint32_t kUntried = 4096;  // the most disks in a first frame, before their cost has been measured

std::uint32_t largest_step(std::uint32_t disks) {
  return std::bit_floor(std::max(1U, disks / kAlways));
}

}  // namespace

std::uint32_t Detail::begin_changed(std::uint32_t disks) {
  // Four times as many disks count as another drawing, whose cost is unknown.
  if (disks > kUntried && (disks / 4 > disks_ || disks_ / 4 > disks)) every_moving_ = largest_step(disks);
  disks_ = disks;
  every_moving_ = std::min(every_moving_, largest_step(disks));
  every_ = every_moving_;
  is_refinement_ = false;
  long_frames_ = 0;
  return every_;
}

std::uint32_t Detail::begin_refinement() {
  if (long_frames_ == 0) every_ = std::max(1U, every_ / 2);
  is_refinement_ = true;
  return every_;
}

void Detail::painted(double milliseconds) {
  if (!is_refinement_) {
    if (milliseconds > kMovingMs) {
      const auto factor = std::bit_ceil(static_cast<std::uint32_t>(std::min(1e6, milliseconds / kMovingMs) + 0.999));
      every_moving_ = std::min(largest_step(disks_), every_moving_ * std::min(factor, 1U << 16U));
    } else if (milliseconds < 0.3 * kMovingMs) {
      every_moving_ = std::max(1U, every_moving_ / 2);
    }
  }
  // Twice as many disks take at most twice the time.
  const bool is_long = 2.0 * milliseconds >= kRestingMs;
  long_frames_ = is_long ? long_frames_ + 1 : 0;
  is_refining_ = every_ > 1 && long_frames_ < kLongFrames;
}

}  // namespace mes

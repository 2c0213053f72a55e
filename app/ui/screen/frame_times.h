// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the time of each turn of the window's loop, by activity.
#pragma once

#include <array>
#include <chrono>

#include "core/draw/patch.h"

namespace mes {

/// Mean times of the last turns that drew something: of the window's own work, and of drawing in the graphics driver.
/// Waiting for events and for the screen does not count.
///
/// Smallest use, each turn:
///     times.begin(); ... times.begin_drawing(); draw(); times.end_drawing(); ... times.end();
class FrameTimes {
 public:
  void begin() {
    begin_ = Clock::now();
    drawing_ = {};
  }
  void begin_drawing() { begin_drawing_ = Clock::now(); }
  void end_drawing() { drawing_ += Clock::now() - begin_drawing_; }
  void end();

  double own_ms() const { return mean(own_); }
  double drawing_ms() const { return mean(drawn_); }
  /// The times as an entry of the statistics.
  NodeReport report() const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kTurns = 64;
  using Times = std::array<double, kTurns>;
  double mean(const Times& times) const;

  Clock::time_point begin_{};
  Clock::time_point begin_drawing_{};
  Clock::duration drawing_{};
  Times own_{};
  Times drawn_{};
  std::size_t turns_ = 0;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// When the next frame is to be drawn.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace mes {

/// What it guarantees: every frame that was wanted is drawn without waiting for an event; with none wanted and nothing
/// due the window sleeps. Threads: none.
///
/// Smallest use, each turn of the window's loop:
///     if (clock.wants_frame()) window.poll(); else window.wait(FrameClock::sleep({...}, is_busy));
///     ... clock.settle();  // something happened
///     draw(); clock.frame_done();
class FrameClock {
 public:
  /// Panels need a few frames after an event until each has its size: one to measure, one to place, one to show.
  static constexpr int kSettlingFrames = 3;

  /// Something happened that may change any panel.
  void settle() { want(kSettlingFrames); }
  /// So many frames from now on, at least.
  void want(int frames) { wanted_ = std::max(wanted_, frames); }
  bool wants_frame() const { return wanted_ > 0; }
  void frame_done() { wanted_ = std::max(0, wanted_ - 1); }

  /// How long to wait for an event, in seconds; 0: without end. What is due first in the list decides; else, while
  /// something is being done, it is the time between two pictures of a progress bar.
  static double sleep(std::initializer_list<std::optional<double>> due, bool is_busy) {
    for (const std::optional<double>& seconds : due)
      if (seconds) return std::clamp(*seconds, kShortestWait, kProgressInterval);
    return is_busy ? kProgressInterval : 0.0;
  }

 private:
  static constexpr double kShortestWait = 1e-3;
  static constexpr double kProgressInterval = 0.08;

  int wanted_ = kSettlingFrames;
};

}  // namespace mes

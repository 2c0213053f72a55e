// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when the next frame is drawn.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace mes {

/// Guarantees: every requested frame is drawn without waiting for an event; if none is requested and nothing is due,
/// the window sleeps. Threads: none.
///
/// Smallest use, each turn of the window's loop:
///     if (clock.wants_frame()) window.poll(); else window.wait(FrameClock::sleep({...}, is_busy));
///     ... clock.settle();  // something happened
///     draw(); clock.frame_done();
class FrameClock {
 public:
  /// Panels need a few frames after an event until each has its size: one to measure, one to place, one to show.
  static constexpr int kSettlingFrames = 3;

  /// Call it after anything that may change a panel.
  void settle() { want(kSettlingFrames); }
  /// Requests at least this many frames from now on.
  void want(int frames) { wanted_ = std::max(wanted_, frames); }
  bool wants_frame() const { return wanted_ > 0; }
  void frame_done() { wanted_ = std::max(0, wanted_ - 1); }

  /// Seconds to wait for an event; 0: without limit. The first time in the list decides; if there is none and work is
  /// under way, it is the time between two pictures of a progress bar.
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

// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter that goes from one value to another in equal steps, one complete picture each.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/document/parameter.h"

namespace mes {

/// Its values differ by orders of magnitude.
inline bool is_wide(const Parameter& descriptor) {
  return descriptor.low > 0.0 && descriptor.high >= 1000.0 * descriptor.low;
}

/// What it guarantees: the first value is `from` and the last one `to`, to the bit; of a whole number each value is
/// whole. Threads: none.
class ParameterAnimation {
 public:
  static constexpr int kMostSteps = 100'000;

  Parameter parameter = Parameter::union_shortcut;
  double from = 0.0;
  double to = 1.0;
  int steps = 50;                  ///< [1, kMostSteps]
  double steps_per_second = 10.0;  ///< at most; each waits for its picture

  /// A range to begin with for a parameter that has this value now: up to twice the value where magnitudes count, else
  /// all that it can be.
  void aim(const Parameter& at, double now) {
    parameter = at;
    from = parameter.low;
    to = parameter.high;
    if (!is_wide(parameter)) return;
    from = now;
    to = now < parameter.high ? std::min(2.0 * now, parameter.high) : 0.5 * now;
  }

  void start() {
    steps = std::clamp(steps, 1, kMostSteps);
    position_ = 0;
    is_running_ = true;
  }
  void stop() { is_running_ = false; }
  bool is_running() const { return is_running_; }
  /// 0 .. steps.
  int position() const { return position_; }
  double value() const {
    if (position_ == steps) return to;
    const double value = from + (to - from) * position_ / steps;
    return parameter.is_whole ? std::round(value) : value;
  }
  /// To be called when the picture of `value` is complete; false: that was the last one.
  bool advance() {
    if (position_ < steps)
      ++position_;
    else
      is_running_ = false;
    return is_running_;
  }

 private:
  int position_ = 0;
  bool is_running_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a parameter from one value to another in equal steps, with one complete picture per step.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/document/settings/parameter.h"

namespace mes {

/// True if the values of the parameter span orders of magnitude.
inline bool is_wide(const Parameter& descriptor) {
  return descriptor.low > 0.0 && descriptor.high >= 1000.0 * descriptor.low;
}

/// Guarantees: the first value is exactly `from` and the last exactly `to`; a parameter of whole numbers gets only
/// whole values. Threads: none.
class ParameterAnimation {
 public:
  static constexpr int kMostSteps = 100'000;

  Parameter parameter = Parameter::union_shortcut;
  double from = 0.0;
  double to = 1.0;
  int steps = 50;                  ///< [1, kMostSteps]
  double steps_per_second = 10.0;  ///< upper limit; each step waits for its picture

  /// Sets an initial range for a parameter with this value: up to twice the value if the parameter spans orders of
  /// magnitude, else its whole range.
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
  /// Number of the present step, from 0 to `steps`.
  int position() const { return position_; }
  double value() const {
    if (position_ == steps) return to;
    const double value = from + (to - from) * position_ / steps;
    return parameter.is_whole ? std::round(value) : value;
  }
  /// Call it when the picture of `value` is complete; returns false if that was the last value.
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

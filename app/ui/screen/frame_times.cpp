// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/screen/frame_times.h"

#include <algorithm>
#include <numeric>

namespace mes {
namespace {

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

void FrameTimes::end() {
  const auto whole = Clock::now() - begin_;
  own_[turns_ % kTurns] = milliseconds(whole - drawing_);
  drawn_[turns_ % kTurns] = milliseconds(drawing_);
  ++turns_;
}

double FrameTimes::mean(const Times& times) const {
  const std::size_t known = std::min(turns_, kTurns);
  return known == 0 ? 0.0 : std::accumulate(times.begin(), times.begin() + known, 0.0) / static_cast<double>(known);
}

NodeReport FrameTimes::report() const {
  NodeReport out;
  out.structure = "window";
  out.state = NodeState::up_to_date;
  out.stats = {{"own_ms", own_ms()}, {"drawing_ms", drawing_ms()}, {"turns", static_cast<std::int64_t>(turns_)}};
  return out;
}

}  // namespace mes

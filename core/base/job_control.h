// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel and progress of one long computation, as one small object.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <stop_token>

#include "core/base/error.h"

namespace mes {

/// Threads: the computation calls `checkpoint`; any thread may read `progress` and request the stop.
class JobControl {
 public:
  JobControl() = default;
  explicit JobControl(std::stop_token token) : token_(std::move(token)) {}

  /// Throws `Cancelled` when a stop was requested; otherwise notes that `done` of `total` steps are behind us.
  /// Cheap, but not free: call it every thousand elements.
  void checkpoint(std::uint64_t done = 0, std::uint64_t total = 0) {
    if (stop_requested()) throw Cancelled{};
    if (total != 0) {
      progress_.store(static_cast<double>(done) / static_cast<double>(total), std::memory_order_relaxed);
    }
  }
  /// Fraction of the current node, in [0, 1].
  double progress() const { return progress_.load(std::memory_order_relaxed); }
  void reset_progress() { progress_.store(0.0, std::memory_order_relaxed); }
  void set_token(std::stop_token token) { token_ = std::move(token); }
  bool stop_requested() const {
    if (looks_left_.load(std::memory_order_relaxed) != kNoLimit && looks_left_.fetch_sub(1) <= 1) return true;
    return token_.stop_requested();
  }
  /// Stops the computation at its `look`-th look, independent of the clock; for tests, which stop it at each
  /// look in turn.
  void stop_at_look(std::int64_t look) { looks_left_ = look; }

 private:
  static constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
  std::stop_token token_;
  mutable std::atomic<std::int64_t> looks_left_{kNoLimit};
  std::atomic<double> progress_{0.0};
};

}  // namespace mes

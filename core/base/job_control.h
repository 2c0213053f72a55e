// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel and progress of one long computation, as one small object.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>
#include <stop_token>

#include "core/base/error.h"

namespace mes {

/// Threads: the computation calls `checkpoint`; any thread may read `progress` and request the stop.
class JobControl {
 public:
  JobControl() = default;
  explicit JobControl(std::stop_token token) : token_(std::move(token)) {}

  /// Throws `Cancelled` when a stop was requested; otherwise notes that `done` of `total` steps are behind us, of the
  /// whole or of the `JobShare` that is open. Cheap, but not free: call it every thousand elements.
  void checkpoint(std::uint64_t done = 0, std::uint64_t total = 0) {
    if (stop_requested()) throw Cancelled{};
    if (total != 0) advance_to(from_ + static_cast<double>(done) / static_cast<double>(total) * (to_ - from_));
  }
  /// Fraction of the current node, in [0, 1]. It does not go back, except by `reset_progress`.
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
  friend class JobShare;
  static constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

  // Threads that do parts of one step side by side come here each with its own.
  void advance_to(double progress) {
    double before = progress_.load(std::memory_order_relaxed);
    while (before < progress && !progress_.compare_exchange_weak(before, progress, std::memory_order_relaxed)) {
    }
  }

  std::stop_token token_;
  mutable std::atomic<std::int64_t> looks_left_{kNoLimit};
  std::atomic<double> progress_{0.0};
  double from_ = 0.0;  // what steps are counted in: the whole, or the share that is open
  double to_ = 1.0;
};

/// One of several jobs that are done one after the other and shown as one. While it is open, steps fill the part of the
/// job from where it is now up to `end`; when it closes, that part is done, unless it was stopped. Shares lie in each other.
///
///     const Faces faces = in_share(job, 0.25, [&] { return triangulate(points, job); });  // 0 to 1/4 of the job
///     return in_share(job, 1.0, [&] { return classify(faces, job); });                    // 1/4 to 1
///
/// Threads: that of the computation, while no other one makes steps of the job.
class JobShare {
 public:
  JobShare(JobControl& job, double end) : job_(job), from_(job.from_), to_(job.to_) {
    job.to_ = from_ + std::clamp(end, 0.0, 1.0) * (to_ - from_);
    job.from_ = std::min(std::max(from_, job.progress()), job.to_);
  }
  ~JobShare() {
    if (std::uncaught_exceptions() == exceptions_) job_.advance_to(job_.to_);
    job_.from_ = from_;
    job_.to_ = to_;
  }
  JobShare(const JobShare&) = delete;
  JobShare& operator=(const JobShare&) = delete;

 private:
  JobControl& job_;
  double from_;
  double to_;
  int exceptions_ = std::uncaught_exceptions();
};

/// What `work()` gives, done as the share of the job up to `end`.
template <class Work>
auto in_share(JobControl& job, double end, Work work) {
  const JobShare share(job, end);
  return work();
}

}  // namespace mes

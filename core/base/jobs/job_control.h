// SPDX-License-Identifier: GPL-3.0-or-later
// Cancellation and progress of one long computation, as one small object.
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

  /// Throws `Cancelled` if a stop was requested; otherwise records that `done` of `total` steps are finished, counted
  /// within the open `JobShare` or within the whole job. Cheap, but not free: call it every thousand elements.
  void checkpoint(std::uint64_t done = 0, std::uint64_t total = 0) {
    if (stop_requested()) throw Cancelled{};
    if (total != 0) advance_to(from_ + static_cast<double>(done) / static_cast<double>(total) * (to_ - from_));
  }
  /// Finished fraction of the current node, in [0, 1]. It decreases only by `reset_progress`.
  double progress() const { return progress_.load(std::memory_order_relaxed); }
  void reset_progress() { progress_.store(0.0, std::memory_order_relaxed); }
  void set_token(std::stop_token token) { token_ = std::move(token); }
  bool stop_requested() const {
    if (looks_left_.load(std::memory_order_relaxed) != kNoLimit && looks_left_.fetch_sub(1) <= 1) return true;
    return token_.stop_requested();
  }
  /// Stops the computation at its `look`-th check, independent of the clock. For tests, which stop it at each check in
  /// turn.
  void stop_at_look(std::int64_t look) { looks_left_ = look; }

 private:
  friend class JobShare;
  static constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

  // Threads that work on parts of one step in parallel each call this with their own progress.
  void advance_to(double progress) {
    double before = progress_.load(std::memory_order_relaxed);
    while (before < progress && !progress_.compare_exchange_weak(before, progress, std::memory_order_relaxed)) {
    }
  }

  std::stop_token token_;
  mutable std::atomic<std::int64_t> looks_left_{kNoLimit};
  std::atomic<double> progress_{0.0};
  double from_ = 0.0;  // range of progress that steps count in: the whole job, or the open share
  double to_ = 1.0;
};

/// One of several consecutive jobs that are shown as one. While the share is open, steps fill the progress from its
/// present value up to `end`; when it closes, the progress is at `end` unless the job was stopped. Shares may be
/// nested.
///
///     const Faces faces = in_share(job, 0.25, [&] { return triangulate(points, job); });  // 0 to 1/4 of the job
///     return in_share(job, 1.0, [&] { return classify(faces, job); });                    // 1/4 to 1
///
/// Threads: the thread of the computation, while no other thread makes steps of the job.
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

/// Runs `work()` as the share of the job up to `end`, and returns its result.
template <class Work>
auto in_share(JobControl& job, double end, Work work) {
  const JobShare share(job, end);
  return work();
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a computation for the state that was asked for last.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// Whether a computation of an earlier state is finished, so that changing pictures are seen.
enum class Outdated : std::uint8_t { finish, give_up };

/// Guarantees:
///  1. Nothing waits: results are computed on a thread of their own, one at a time. While the state keeps changing, the
///     results of some of its moments are given; the next one begins when the one before has ended.
///  2. No state is computed twice in a row, even if it has no result.
///  3. A computation that nothing followed since the last `end_frame` is given up, and so is one of an earlier state
///     where `Outdated::give_up` says so.
///
/// Smallest use, once a frame:
///     latest.follow(document.revision(), [&] {
///       return [data = data_of(document)](JobControl& job) { return table_of(data, job); };
///     });
///     if (latest.is_current()) draw(*latest.result());
///     latest.end_frame();
///
/// Threads: one for all members; computations and the waker run on others.
template <class State, class Result>
class Latest {
 public:
  /// May throw `Cancelled` and std::bad_alloc.
  using Compute = std::function<Expected<Result>(JobControl&)>;

  explicit Latest(Waker wake, Outdated outdated = Outdated::finish) : job_(std::move(wake)), outdated_(outdated) {}

  /// Takes what is ready, and begins what is missing; `compute` is asked for the computation, and copies its data, only
  /// when one begins. True: a result was taken, or the reason why there is none.
  template <class MakeCompute>
  bool follow(const State& wanted, MakeCompute compute) {
    wanted_ = wanted;
    is_followed_ = true;
    bool is_new = false;
    if (auto outcome = job_.poll()) {
      is_new = true;
      if (outcome->result)
        last_ = std::move(*outcome);
      else
        failed_ = std::move(*outcome);
    }
    if (outdated_ == Outdated::give_up && begun_ != wanted) give_up();
    if (is_under_way() || is_current() || has_failed()) return is_new;
    begun_ = wanted;
    job_.begin([state = wanted, compute = Compute(compute())](const std::stop_token& stop) -> Outcome {
      JobControl job(stop);
      try {
        auto result = compute(job);
        if (!result) return {state, nullptr, result.error().message()};
        return {state, std::make_shared<const Result>(*std::move(result)), {}};
      } catch (const Cancelled&) {
        return {state, nullptr, "the computation was stopped"};
      } catch (const std::bad_alloc&) {
        return {state, nullptr, "there is not enough memory"};
      }
    });
    return is_new;
  }
  void give_up() { job_.give_up(); }
  /// Once a frame, after those who may follow.
  void end_frame() {
    if (!std::exchange(is_followed_, false)) give_up();
  }
  /// Since the last `end_frame`.
  bool is_followed() const { return is_followed_; }
  bool is_under_way() const { return job_.is_under_way() || job_.is_ending(); }

  /// The last result; null before the first.
  const std::shared_ptr<const Result>& result() const { return last_.result; }
  /// The state of the result.
  const State& state() const { return last_.state; }
  /// The result is that of the state followed last.
  bool is_current() const { return last_.result != nullptr && last_.state == wanted_; }
  /// Why the state followed last has no result; empty: it has one, or is not computed yet.
  std::string problem() const { return has_failed() ? failed_->problem : std::string(); }

 private:
  struct Outcome {
    State state{};
    std::shared_ptr<const Result> result{};
    std::string problem{};
  };
  bool has_failed() const { return failed_ && failed_->state == wanted_; }

  BackgroundJob<Outcome> job_;
  Outdated outdated_;
  State begun_{};  // of the computation begun last
  bool is_followed_ = false;
  State wanted_{};
  Outcome last_;
  std::optional<Outcome> failed_;
};

}  // namespace mes

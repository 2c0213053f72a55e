// SPDX-License-Identifier: GPL-3.0-or-later
// A call that takes long, on a thread of its own, and what came of it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/system/waker.h"

namespace mes {

/// What it guarantees:
///  1. `begin` returns at once. The call runs on a thread of its own; `wake` is called from there when it has ended,
///     and counts it as work until then.
///  2. What the call returned is given once, by `poll` or `finish`. What it threw, std::bad_alloc among it, they throw
///     in its place, and the object is as before `begin`.
///  3. Of calls that were begun one after the other only the last is delivered: those before are given up. A call
///     that was given up is asked to stop; others do not wait for it. What it returns or throws is destroyed on its own
///     thread, or on another one if it had ended before: however large it is, the caller does not wait for that either.
///  4. The destructor asks every call to stop and waits for its end. A call that must be complete does not look at
///     its stop token.
///
/// Smallest use:
///     BackgroundJob<std::string> job(wake);
///     job.begin([file](const std::stop_token&) { return read(file); });
///     ... each frame: if (auto text = job.poll()) show(*text);
///
/// Cost: a thread for each call. `begin` throws std::system_error when the system has none left.
/// Threads: one for all members; the call and `wake` run on the call's.
template <class Result>
class BackgroundJob {
 public:
  using Call = std::function<Result(const std::stop_token&)>;

  explicit BackgroundJob(Waker wake) : wake_(std::move(wake)) {}
  ~BackgroundJob() {
    if (run_) run_->thread.request_stop();
  }
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  void begin(Call call) {
    give_up();
    std::erase_if(given_up_, [](const auto& run) { return run->is_empty.load(); });
    auto run = std::make_unique<Run>();
    run->thread = std::jthread([run = run.get(), call = std::move(call), wake = wake_,
                                work = wake_.begin_work()](const std::stop_token& stop) mutable {
      try {
        run->result.emplace(call(stop));
      } catch (...) {
        run->failure = std::current_exception();
      }
      auto before = Delivery::awaited;
      if (!run->delivery.compare_exchange_strong(before, Delivery::ready)) run->drop();
      run->has_ended = true;
      work.end();
      wake();
    });
    run_ = std::move(run);
  }

  void give_up() {
    if (!run_) return;
    run_->thread.request_stop();
    Run& run = *run_;
    given_up_.push_back(std::move(run_));
    auto before = Delivery::awaited;
    if (run.delivery.compare_exchange_strong(before, Delivery::unwanted)) return;
    try {
      // The thread before is at its end, and waited for.
      run.thread = std::jthread([&run] { run.drop(); });
    } catch (const std::exception&) {
      run.drop();
    }
  }

  /// A call that was given up has not ended yet; `wake` is called when it has.
  bool is_ending() const {
    return std::ranges::any_of(given_up_, [](const auto& run) { return !run->has_ended; });
  }

  /// It was begun, and what came of it was not taken.
  bool is_under_way() const { return run_ != nullptr; }

  /// What came of it can be taken.
  bool has_ended() const { return run_ && run_->has_ended; }
  /// Nothing while the call runs, or when none is under way.
  std::optional<Result> poll() { return has_ended() ? finish() : std::nullopt; }

  /// Waits for the call's end; nothing when none is under way.
  std::optional<Result> finish() {
    if (!run_) return std::nullopt;
    const std::unique_ptr<Run> run = std::move(run_);
    run->thread.join();
    if (run->failure) std::rethrow_exception(run->failure);
    return std::move(run->result);
  }

 private:
  enum class Delivery : std::uint8_t { awaited, ready, unwanted };
  struct Run {
    std::atomic<bool> has_ended = false;
    std::atomic<Delivery> delivery = Delivery::awaited;
    std::atomic<bool> is_empty = false;  // what it returned was destroyed
    std::optional<Result> result;
    std::exception_ptr failure;
    void drop() {
      result.reset();
      failure = nullptr;
      is_empty = true;
    }
    std::jthread thread;  // last: it ends before what it writes to
  };

  Waker wake_;
  std::unique_ptr<Run> run_;
  std::vector<std::unique_ptr<Run>> given_up_;
};

}  // namespace mes

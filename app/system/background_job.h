// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a call that takes long on a thread of its own, and delivers its result.
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

/// Guarantees:
///  1. `begin` returns at once. The call runs on a thread of its own, which calls `wake` when the call has ended.
///     Until then `wake` counts it as work.
///  2. `poll` or `finish` deliver the result once. If the call threw, std::bad_alloc included, they throw that
///     instead, and the object is as before `begin`.
///  3. When several calls are begun one after the other, only the last is delivered: the earlier ones are given up. A
///     call that is given up is asked to stop; the others do not wait for it. Its result or exception is destroyed on
///     its own thread, or on another one if it had already ended, so that the caller never waits even for a large
///     result.
///  4. The destructor asks every call to stop and waits for its end. A call that must be complete does not look at
///     its stop token.
///
/// Smallest use:
///     BackgroundJob<std::string> job(wake);
///     job.begin([file](const std::stop_token&) { return read(file); });
///     ... each frame: if (auto text = job.poll()) show(*text);
///
/// Cost: a thread for each call. `begin` throws std::system_error when the system has no thread left. Threads: all
/// members on one thread; the call and `wake` run on the call's own.
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
      // The run's former thread has finished; the assignment joins it.
      run.thread = std::jthread([&run] { run.drop(); });
    } catch (const std::exception&) {
      run.drop();
    }
  }

  /// True while a call that was given up has not ended yet; `wake` is called when it has.
  bool is_ending() const {
    return std::ranges::any_of(given_up_, [](const auto& run) { return !run->has_ended; });
  }

  /// True from `begin` until the result is taken.
  bool is_under_way() const { return run_ != nullptr; }

  /// True when the result can be taken.
  bool has_ended() const { return run_ && run_->has_ended; }
  /// The result; nothing while the call runs, or when none is under way.
  std::optional<Result> poll() { return has_ended() ? finish() : std::nullopt; }

  /// Waits for the call's end and returns its result; nothing when none is under way.
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
    std::atomic<bool> is_empty = false;  // the result has been destroyed
    std::optional<Result> result;
    std::exception_ptr failure;
    void drop() {
      result.reset();
      failure = nullptr;
      is_empty = true;
    }
    std::jthread thread;  // last: joined before the members it writes to are destroyed
  };

  Waker wake_;
  std::unique_ptr<Run> run_;
  std::vector<std::unique_ptr<Run>> given_up_;
};

}  // namespace mes

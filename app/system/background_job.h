// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a call that takes long on a thread of its own, and delivers its result.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "app/system/waker.h"

namespace mes {

/// The threads of a `BackgroundJob`, whatever its result is.
class BackgroundRuns {
 public:
  using Call = std::function<std::shared_ptr<void>(const std::stop_token&)>;

  explicit BackgroundRuns(Waker wake);
  ~BackgroundRuns();
  BackgroundRuns(const BackgroundRuns&) = delete;
  BackgroundRuns& operator=(const BackgroundRuns&) = delete;

  void begin(Call call);
  void give_up();
  bool is_ending() const;
  bool is_under_way() const { return run_ != nullptr; }
  bool has_ended() const;
  std::shared_ptr<void> finish();

 private:
  struct Run;
  Waker wake_;
  std::unique_ptr<Run> run_;
  std::vector<std::unique_ptr<Run>> given_up_;
};

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

  explicit BackgroundJob(Waker wake) : runs_(std::move(wake)) {}

  void begin(Call call) {
    runs_.begin(
        [call = std::move(call)](const std::stop_token& stop) { return std::make_shared<Result>(call(stop)); });
  }
  void give_up() { runs_.give_up(); }
  /// True while a call that was given up has not ended yet; `wake` is called when it has.
  bool is_ending() const { return runs_.is_ending(); }
  /// True from `begin` until the result is taken.
  bool is_under_way() const { return runs_.is_under_way(); }
  /// True when the result can be taken.
  bool has_ended() const { return runs_.has_ended(); }
  /// The result; nothing while the call runs, or when none is under way.
  std::optional<Result> poll() { return has_ended() ? finish() : std::nullopt; }
  /// Waits for the call's end and returns its result; nothing when none is under way.
  std::optional<Result> finish() {
    const std::shared_ptr<void> result = runs_.finish();
    if (!result) return std::nullopt;
    return std::move(*static_cast<Result*>(result.get()));
  }

 private:
  BackgroundRuns runs_;
};

}  // namespace mes

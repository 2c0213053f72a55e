// SPDX-License-Identifier: GPL-3.0-or-later
// Wakes the loop of the window from other threads, and counts their work.
#pragma once

#include <atomic>
#include <concepts>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace mes {

/// Guarantees: copies wake the same loop and share one count. A default waker wakes nothing.
///
/// Smallest use:
///     const Waker wake([&] { loop.wake(); });
///     std::jthread thread([work = wake.begin_work(), wake]() mutable { compute(); work.end(); wake(); });
///     if (wake.has_work()) show_progress();
///
/// Threads: any.
class Waker {
  struct State {
    std::function<void()> wake;
    std::atomic<int> works = 0;
  };

 public:
  /// Work that is under way until `end`, or until it is destroyed.
  class Work {
   public:
    Work(Work&&) = default;
    Work& operator=(Work&&) = delete;
    ~Work() { end(); }
    void end() {
      if (const auto state = std::exchange(state_, nullptr)) --state->works;
    }

   private:
    friend class Waker;
    explicit Work(std::shared_ptr<State> state) : state_(std::move(state)) { ++state_->works; }
    std::shared_ptr<State> state_;
  };

  Waker() = default;
  template <std::invocable Wake>
  requires(!std::same_as<std::remove_cvref_t<Wake>, Waker>) Waker(Wake wake) {  // NOLINT: made of any callable
    state_->wake = std::move(wake);
  }

  void operator()() const {
    if (state_->wake) state_->wake();
  }
  Work begin_work() const { return Work(state_); }
  bool has_work() const { return state_->works > 0; }

 private:
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace mes

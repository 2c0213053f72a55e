// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks found one by one, done by other cores while the thread that finds them goes on.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "core/base/parallel.h"

namespace mes {

/// What it guarantees:
///  1. Each task is done once, by some thread, before `finish` returns; or it had not begun when `drop` was called.
///  2. No thread of it is left when either returns. Without tasks it costs nothing: threads start with the first.
///  3. `add` throws only when the task was not taken. Threads that the system does not give are done without.
/// Tasks must not throw.
///
/// Smallest use:
///     TaskQueue tasks;
///     tasks.add([&] { fill(a); });
///     compute(b);
///     tasks.finish();
///
/// Threads: all methods are called by one thread, which lends a hand in `finish`.
class TaskQueue {
 public:
  TaskQueue() = default;
  ~TaskQueue() { drop(); }
  TaskQueue(const TaskQueue&) = delete;
  TaskQueue& operator=(const TaskQueue&) = delete;

  void add(std::function<void()> task) {
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(std::move(task));
    }
    if (threads_.size() + 1 < worker_count()) {
      try {
        threads_.emplace_back([this] { work(); });
        return;
      } catch (const std::system_error&) {
        // Without a thread for it the task waits for one of the others, or for `finish`.
      } catch (const std::bad_alloc&) {
      }
    }
    there_is_more_.notify_one();
  }
  /// No task was added since the start or the last `finish` or `drop`.
  bool is_empty() const { return tasks_.empty(); }
  /// Returns when every task is done.
  void finish() {
    if (tasks_.empty()) return;
    while (const auto task = next()) task();
    stop();
  }
  /// Forgets what has not begun, and waits for what has.
  void drop() {
    if (tasks_.empty()) return;
    {
      const std::lock_guard lock(mutex_);
      next_ = tasks_.size();
    }
    stop();
  }

 private:
  void work() {
    for (;;) {
      {
        std::unique_lock lock(mutex_);
        there_is_more_.wait(lock, [this] { return next_ < tasks_.size() || ends_; });
        if (next_ == tasks_.size()) return;
      }
      if (const auto task = next()) task();
    }
  }
  std::function<void()> next() {
    const std::lock_guard lock(mutex_);
    return next_ < tasks_.size() ? std::move(tasks_[next_++]) : nullptr;
  }
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    there_is_more_.notify_all();
    threads_.clear();
    tasks_.clear();
    next_ = 0;
    ends_ = false;
  }

  std::mutex mutex_;
  std::condition_variable there_is_more_;
  std::vector<std::function<void()>> tasks_;
  std::size_t next_ = 0;
  bool ends_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// A queue of tasks that other cores work on while its thread adds more.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "core/base/jobs/parallel.h"

namespace mes {

/// Guarantees:
///  1. Each task runs once, on some thread, before `finish` returns, unless it had not begun when `drop` was called.
///  2. No thread of the queue runs after either returns. An unused queue costs nothing: threads start with the first
///     task.
///  3. `add` throws only if the task was not accepted. If the system grants fewer threads, the queue works with fewer.
/// Tasks must not throw.
///
/// Smallest use:
///     TaskQueue tasks;
///     tasks.add([&] { fill(a); });
///     compute(b);
///     tasks.finish();
///
/// Threads: one thread calls all methods; it helps with the tasks in `finish`.
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
        // If no new thread starts, the task waits for one of the others, or for `finish`.
      } catch (const std::bad_alloc&) {
      }
    }
    there_is_more_.notify_one();
  }
  /// True if no task was added since the start or the last `finish` or `drop`.
  bool is_empty() const { return tasks_.empty(); }
  /// Returns when every task is done.
  void finish() {
    if (tasks_.empty()) return;
    while (const auto task = next()) task();
    stop();
  }
  /// Drops tasks that have not begun, and waits for those that have.
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

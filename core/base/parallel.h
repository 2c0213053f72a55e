// SPDX-License-Identifier: GPL-3.0-or-later
// Loops and tasks over all cores, for work of milliseconds and more.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace mes {

/// Number of threads worth using, 1 to 16.
inline std::size_t worker_count() {
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 16);
}

/// Calls `task(i)` once for each i below `count`, on several threads; returns when all are done. The first exception,
/// if any, is thrown here after that. Threads that the system does not give are done without. Starting threads costs
/// some 30 us each.
template <class Task>
void run_tasks(std::size_t count, Task task) {
  const std::size_t workers = std::min(worker_count(), count);
  if (workers <= 1) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    try {
      for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

/// Splits [0, count) into ranges and calls `body(begin, end, chunk)` for each, on several threads.
/// `chunk_count(count)` says how many there will be, and `first_of_chunk` where each begins; the split depends on
/// `count` alone.
inline std::size_t chunk_count(std::size_t count) {
  constexpr std::size_t kChunk = std::size_t{1} << 15U;
  return (count + kChunk - 1) / kChunk;
}
inline std::size_t first_of_chunk(std::size_t count, std::size_t chunk) {
  return count * chunk / chunk_count(count);
}
template <class Body>
void parallel_for(std::size_t count, Body body) {
  run_tasks(chunk_count(count),
            [&](std::size_t chunk) { body(first_of_chunk(count, chunk), first_of_chunk(count, chunk + 1), chunk); });
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Loops and tasks on all cores, for work of milliseconds and more.
#pragma once

#include <cstddef>
#include <functional>

namespace mes {

/// Number of threads worth using, 1 to 16.
std::size_t worker_count();

/// Calls `task(i)` once for each i below `count`, on several threads; returns when all are done, and then rethrows the
/// first exception, if any. If the system grants fewer threads, it works with fewer. Starting a thread costs about 30
/// us.
void run_tasks(std::size_t count, const std::function<void(std::size_t)>& task);

/// Splits [0, count) into ranges and calls `body(begin, end, chunk)` for each, on several threads.
/// `chunk_count(count)` is their number, and `first_of_chunk` the begin of each; the split depends on `count` alone.
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

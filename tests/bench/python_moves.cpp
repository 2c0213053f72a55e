// SPDX-License-Identifier: GPL-3.0-or-later
// What python.py does, in C++: a move and the rows that it changed, copied.
#include <mesecina/mesecina.h>

#include <algorithm>
#include <chrono>
#include <vector>

/// Microseconds that each of `count` moves of one sample took, the median.
extern "C" double moves(const double* coordinates, std::size_t samples, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  mesecina::Workbench bench;
  const auto* const points = reinterpret_cast<const mesecina::Point*>(coordinates);
  const std::vector<mesecina::SampleId> ids = bench.insert(std::span(points, samples));
  bench.need({"medial-axis"});
  bench.run();
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    const mesecina::Point to{points[5].x + 1e-9 * static_cast<double>(i % 2 + 1), points[5].y};
    const auto begin = Clock::now();
    bench.move(ids[5], to);
    bench.run();
    const auto changes = bench.table("medial-axis/edges").changes();
    const std::vector<mesecina::Row> touched(changes->touched.begin(), changes->touched.end());
    const std::vector<mesecina::Row> removed(changes->removed.begin(), changes->removed.end());
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count / 2), times.end());
  return times[count / 2];
}

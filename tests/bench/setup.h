// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs and graphs of the benchmarks.
#pragma once

#include <time.h>

#include <chrono>
#include <memory>
#include <string_view>
#include <vector>

#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "tests/support/builtin_layers.h"

namespace mes::bench {

inline double now_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of this thread alone: for what is done on one thread, so that other programs do not count.
inline double own_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Of all threads of this process.
inline double process_us() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

inline std::vector<LayerIndex> layers_named(std::initializer_list<std::string_view> ids) {
  std::vector<LayerIndex> out;
  for (const std::string_view id : ids) out.push_back(find_layer(id));
  return out;
}

inline std::shared_ptr<const DocumentDelta> replace_with(const Document& document, const std::vector<Vec2>& points) {
  SampleData data;
  data.positions = points;
  return std::make_shared<const DocumentDelta>(*replace_all(document, data));
}

}  // namespace mes::bench

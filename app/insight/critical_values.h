// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values of the distance to the samples on the axis, where the lambda axis may change its topology.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/system/latest.h"
#include "core/document/sample_data.h"
#include "core/graph/live_registry.h"

namespace mes {

/// The critical values, ascending and distinct (`LambdaAxis::critical_values`); the first is the estimate of the weak
/// feature size. Throws `Cancelled`. Error: a structure failed. Cost: the axis from scratch.
Expected<std::vector<double>> critical_values_of(const Registry& registry, const SampleData& data, JobControl& job);

/// The critical values of the document, computed on a thread of their own, one job at a time, while they are
/// displayed. Threads: the window's; `wake` is called from the other.
class CriticalValues {
 public:
  CriticalValues(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  /// Takes finished values, and begins a missing computation. Calls `data` when a computation begins.
  void follow(std::uint64_t document, const std::function<SampleData()>& data);
  /// Call it once per frame after all possible calls of `follow`: if there was none, the computation is given up.
  void end_frame() { latest_.end_frame(); }
  /// The values of the document followed last; null while they are unknown.
  const std::vector<double>* values() const { return latest_.is_current() ? latest_.result().get() : nullptr; }
  /// The reason why they are unavailable; empty if there is none.
  std::string problem() const { return latest_.problem(); }

 private:
  LiveRegistry registry_;
  Latest<std::uint64_t, std::vector<double>> latest_;
};

}  // namespace mes

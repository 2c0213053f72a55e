// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values of the distance to the samples on the axis, at which the lambda axis may change its topology.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/system/latest.h"
#include "core/document/commands.h"
#include "core/graph/live_registry.h"

namespace mes {

/// Ascending, each once (`LambdaAxis::critical_values`); the first is the estimate of the weak feature size. Throws
/// `Cancelled`. Error: a structure failed. Cost: of the axis from scratch.
Expected<std::vector<double>> critical_values_of(const Registry& registry, const SampleData& data, JobControl& job);

/// Those of the document, found on a thread of their own, one at a time, while they are looked at. Threads: the
/// window's; `wake` is called from the other.
class CriticalValues {
 public:
  CriticalValues(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  /// Takes what is ready, and begins what is missing. `data` is called when a computation begins.
  void follow(std::uint64_t document, const std::function<SampleData()>& data);
  /// Once a frame, after those who may follow: what nothing followed is given up.
  void end_frame() { latest_.end_frame(); }
  /// Of the document followed last; null while they are not known.
  const std::vector<double>* values() const { return latest_.is_current() ? latest_.result().get() : nullptr; }
  /// Why they cannot be had; empty: they can.
  std::string problem() const { return latest_.problem(); }

 private:
  LiveRegistry registry_;
  Latest<std::uint64_t, std::vector<double>> latest_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps a parameter through its values, and writes counts and measures as CSV.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/insight/parameter_animation.h"
#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/draw/layer_descriptor.h"
#include "core/graph/live_registry.h"

namespace mes {

struct ParameterSweep {
  SampleData data{};
  ComputationSettings settings{};    ///< the other parameters
  ParameterAnimation range{};        ///< the parameter, its range and the number of steps
  std::vector<LayerIndex> layers{};  ///< measured together with the structures that they need
};

/// One line for each value. The columns are the numbers that `mesecina compute` gives for any of the values, in order
/// of appearance; a line that lacks one has an empty cell. Calls `progress` with the finished share. Throws
/// `Cancelled`. Error: the data cannot be a document, or a layer failed. Cost: one run from scratch, and a change of
/// the parameter for each further value.
Expected<std::string> sweep_as_csv(const Registry& registry, const ParameterSweep& sweep,
                                   const std::function<void(double)>& progress, JobControl& job);

/// Runs one sweep at a time on a thread of its own. Threads: the window's; `wake` is called from the other.
class SweepJob {
 public:
  SweepJob(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), job_(std::move(wake)) {}

  void begin(ParameterSweep sweep);
  void give_up() { job_.give_up(); }
  bool is_under_way() const { return job_.is_under_way(); }
  /// Finished share of the sweep.
  double progress() const { return done_->load(std::memory_order_relaxed); }
  /// The table, or the reason why there is none; given once.
  std::optional<Expected<std::string>> poll() { return job_.poll(); }

 private:
  LiveRegistry registry_;
  BackgroundJob<Expected<std::string>> job_;
  std::shared_ptr<std::atomic<double>> done_ = std::make_shared<std::atomic<double>>(0.0);
};

}  // namespace mes

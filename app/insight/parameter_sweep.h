// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and measures while a parameter goes through its values, as CSV.
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
#include "core/base/job_control.h"
#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/draw/layer_descriptor.h"
#include "core/graph/live_registry.h"

namespace mes {

struct ParameterSweep {
  SampleData data{};
  ComputationSettings settings{};    ///< the other parameters
  ParameterAnimation range{};        ///< which parameter, from where to where, in how many steps
  std::vector<LayerIndex> layers{};  ///< measured with the structures that they need
};

/// One line for each value; the columns are the numbers that `mesecina compute` gives for any of the values, in the order in
/// which they come. A line that lacks some has empty cells there. `progress` is called with the share that is done. Throws `Cancelled`. Error:
/// the data cannot be a document, or a layer failed. Cost: of a run from scratch, and of a change of the parameter for each
/// further value.
Expected<std::string> sweep_as_csv(const Registry& registry, const ParameterSweep& sweep,
                                   const std::function<void(double)>& progress, JobControl& job);

/// One sweep at a time, on a thread of its own. Threads: the window's; `wake` is called from the other.
class SweepDesk {
 public:
  SweepDesk(LiveRegistry registry, Waker wake)
      : registry_(std::move(registry)), job_(std::move(wake)) {}

  void begin(ParameterSweep sweep);
  void give_up() { job_.give_up(); }
  bool is_under_way() const { return job_.is_under_way(); }
  /// Share that is done.
  double progress() const { return done_->load(std::memory_order_relaxed); }
  /// The table or why there is none, once.
  std::optional<Expected<std::string>> poll() { return job_.poll(); }

 private:
  LiveRegistry registry_;
  BackgroundJob<Expected<std::string>> job_;
  std::shared_ptr<std::atomic<double>> done_ = std::make_shared<std::atomic<double>>(0.0);
};

}  // namespace mes

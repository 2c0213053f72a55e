// SPDX-License-Identifier: GPL-3.0-or-later
// One line on a terminal that says how far the work is and how long it will take.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "app/export/computation.h"

namespace mes::cli {

/// Writes to stderr, only if that is a terminal and only if the work takes longer than 0.4 s. The line is
/// removed with the object.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` of the whole work in [0, 1].
  void show(std::string_view task, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  double shown_fraction_ = 0.0;
  Clock::time_point started_ = Clock::now();
  Clock::time_point last_;
};

/// `run_computation`, whose progress a terminal shows until it ends.
Expected<ComputationResult> compute_with_progress(const Registry& registry, const SampleData& data,
                                                  ComputationRequest request);

/// `run_one_shot`, in the same way.
Expected<ComputationReport> measure_with_progress(const Registry& registry, SampleData data,
                                                  ComputationRequest request,
                                                  std::function<void(const InstancePiece&)> take);

/// "3 s", "2 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// A line on a terminal that shows the progress of the work and the remaining time.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "app/export/computation.h"

namespace mes::cli {

/// Writes to stderr, only if that is a terminal and only if the work takes longer than 0.4 s. The destructor removes
/// the line.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` is the finished share of the whole work, in [0, 1].
  void show(std::string_view task, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  double shown_fraction_ = 0.0;
  Clock::time_point started_ = Clock::now();
  Clock::time_point last_;
};

/// `run_computation`, with its progress on a terminal until it ends.
Expected<ComputationResult> compute_with_progress(const Registry& registry, const SampleData& data,
                                                  ComputationRequest request);

/// The same for `run_one_shot`.
Expected<ComputationReport> measure_with_progress(const Registry& registry, SampleData data,
                                                  ComputationRequest request,
                                                  std::function<void(const InstancePiece&)> take);

/// A duration as text: "3 s", "2 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);

}  // namespace mes::cli

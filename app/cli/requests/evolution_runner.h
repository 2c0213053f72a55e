// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the states of an evolution in order, and shows the progress on a terminal.
#pragma once

#include <cstdint>
#include <optional>

#include "app/cli/console/progress.h"
#include "core/base/error.h"
#include "core/evolutions/evolution.h"

namespace mes::cli {

/// Keeps no earlier states, because they are not requested again. For evolutions that move samples.
class EvolutionRunner {
 public:
  EvolutionRunner(EvolutionState beginning, EvolutionChoice choice)
      : beginning_(std::move(beginning)), choice_(std::move(choice)) {}

  /// The state of a step, which must not precede the last requested one; `last` is the final step. Error: as
  /// `next_state`. Valid until the next call.
  Expected<EvolutionState> at(std::uint64_t step, std::uint64_t last);

 private:
  std::optional<EvolutionState> beginning_;
  std::optional<EvolutionState> now_;
  std::uint64_t step_ = 0;
  EvolutionChoice choice_;
  Progress progress_;
};

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// States of an evolution one after the other, with the progress shown on a terminal.
#pragma once

#include <cstdint>
#include <optional>

#include "app/cli/progress.h"
#include "core/base/error.h"
#include "core/evolutions/evolution.h"

namespace mes::cli {

/// Earlier states are not asked for again, so none is kept. For evolutions that move samples.
class EvolutionRunner {
 public:
  EvolutionRunner(EvolutionState beginning, EvolutionChoice choice)
      : beginning_(std::move(beginning)), choice_(std::move(choice)) {}

  /// The state of a step, not before the last one that was asked for; `last` is where it will end. Error: as
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

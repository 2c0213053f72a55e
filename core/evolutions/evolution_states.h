// SPDX-License-Identifier: GPL-3.0-or-later
// The states of one evolution, computed on request and kept within a memory budget.
//
// Guarantees:
//  1. State k is the same, however often and in whatever order states are requested: dropped states are computed again
//     from an earlier one.
//  2. Kept states stay within the budget, apart from state 0, the last state computed, and the last one returned.
//
// Smallest use:
//     EvolutionStates states(state_of(document), {.evolution = registry.evolutions().find("smooth")});
//     auto state = states.at(12, job);
//
// Cost: one step for each state between the requested one and the nearest kept one before it. When the budget is used
// up, every second checkpoint is dropped. The states of the current stretch are kept too, so that backward playback
// computes each stretch once. Threads: none.
#pragma once

#include <functional>
#include <map>

#include "core/evolutions/evolution.h"

namespace mes {

class EvolutionStates {
 public:
  static constexpr std::size_t kDefaultBudget = std::size_t{512} << 20U;
  using Shared = std::shared_ptr<const EvolutionState>;

  EvolutionStates(EvolutionState beginning, EvolutionChoice choice, std::size_t budget_bytes = kDefaultBudget);

  /// Throws `Cancelled`; states computed until then are kept. `on_step` is called for each state on the way. Error: as
  /// `next_state`.
  Expected<Shared> at(std::uint64_t k, JobControl& job, const std::function<void(std::uint64_t)>& on_step = {});

  const EvolutionChoice& choice() const { return choice_; }
  std::size_t kept_bytes() const { return checkpoint_bytes_ + stretch_bytes_; }

 private:
  void keep(std::uint64_t k, const Shared& state);

  EvolutionChoice choice_;
  std::size_t budget_;
  bool has_begun_ = false;
  std::uint64_t stride_ = 1;
  std::map<std::uint64_t, Shared> checkpoints_;  // at multiples of the stride
  std::map<std::uint64_t, Shared> stretch_;      // between two checkpoints
  std::size_t checkpoint_bytes_ = 0;
  std::size_t stretch_bytes_ = 0;
};

}  // namespace mes

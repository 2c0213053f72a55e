// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/evolution_runner.h"

#include <fmt/core.h>
#include <utility>

#include "core/base/assert.h"

namespace mes::cli {

Expected<EvolutionState> EvolutionRunner::at(std::uint64_t step, std::uint64_t last) {
  MES_ASSERT(step >= step_);
  JobControl job;
  if (!now_) {
    auto first = begin_evolution(std::move(*beginning_), choice_, job);
    beginning_.reset();
    if (!first) return first;
    now_ = std::move(*first);
  }
  while (step_ < step) {
    auto next = next_state(*now_, step_, choice_, job);
    if (!next) return next;
    now_ = std::move(*next);
    ++step_;
    progress_.show(fmt::format("step {}", step_), static_cast<double>(step_) / static_cast<double>(last));
  }
  return *now_;
}

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolutions/evolution_states.h"

#include <iterator>
#include <utility>

namespace mes {

EvolutionStates::EvolutionStates(EvolutionState beginning, EvolutionChoice choice, std::size_t budget_bytes)
    : choice_(std::move(choice)), budget_(budget_bytes) {
  checkpoints_.emplace(0, std::make_shared<const EvolutionState>(std::move(beginning)));
}

void EvolutionStates::keep(std::uint64_t k, const Shared& state) {
  const EvolutionState& first = *checkpoints_.at(0);
  const std::size_t size = state->bytes_beside(first);
  if (k % stride_ == 0) {
    if (checkpoints_.emplace(k, state).second) checkpoint_bytes_ += size;
    while (checkpoint_bytes_ > budget_ / 2 && checkpoints_.size() > 2) {
      stride_ *= 2;
      std::erase_if(checkpoints_, [&](const auto& entry) {
        const bool is_dropped = entry.first % stride_ != 0;
        if (is_dropped) checkpoint_bytes_ -= entry.second->bytes_beside(first);
        return is_dropped;
      });
    }
    return;
  }
  // States of another stretch, or too many of them: drop those far from the requested state.
  const auto is_elsewhere = [&](const auto& entry) { return entry.first / stride_ != k / stride_; };
  if (stretch_bytes_ + size > budget_ / 2 || (!stretch_.empty() && is_elsewhere(*stretch_.begin()))) {
    stretch_.clear();
    stretch_bytes_ = 0;
  }
  if (stretch_.emplace(k, state).second) stretch_bytes_ += size;
}

Expected<EvolutionStates::Shared> EvolutionStates::at(std::uint64_t k, JobControl& job,
                                                      const std::function<void(std::uint64_t)>& on_step) {
  if (!has_begun_) {
    Shared& first = checkpoints_.at(0);
    auto begun = begin_evolution(*first, choice_, job);
    if (!begun) return std::unexpected(begun.error());
    first = std::make_shared<const EvolutionState>(std::move(*begun));
    has_begun_ = true;
  }
  const auto last_before = [k](const std::map<std::uint64_t, Shared>& states) {
    const auto after = states.upper_bound(k);
    return after == states.begin() ? states.end() : std::prev(after);
  };
  auto nearest = last_before(checkpoints_);
  if (const auto in_stretch = last_before(stretch_);
      in_stretch != stretch_.end() && in_stretch->first > nearest->first)
    nearest = in_stretch;
  std::uint64_t reached = nearest->first;
  Shared state = nearest->second;
  while (reached < k) {
    auto next = next_state(*state, reached, choice_, job);
    if (!next) return std::unexpected(next.error());
    state = std::make_shared<const EvolutionState>(std::move(*next));
    keep(++reached, state);
    if (on_step) on_step(reached);
  }
  return state;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work/difference_marks.h"

#include <new>
#include <utility>

namespace mes {

DifferenceMarks::Compared DifferenceMarks::compare_panes(Panes panes, const State& state) {
  Compared out{.state = state, .patch = {}, .marks = {}, .problem = panes.problem};
  if (out.problem) return out;
  try {
    Comparison& comparison = panes.comparison;
    out.patch = mark_differences(comparison, *panes.drawn, panes.extent);
    for (Pane& pane : comparison.panes) out.marks.push_back(std::move(pane.marks));
  } catch (const std::bad_alloc&) {
    out.problem = Error{ErrorCode::out_of_memory, "there is not enough memory", {}, 0, 0};
  }
  return out;
}

void DifferenceMarks::follow(const std::optional<State>& state, bool later, std::uint64_t panes_revision,
                             const std::function<Panes()>& panes, Picture& picture) {
  if (auto compared = comparing_.poll()) {
    is_comparing_ = false;
    if (compared->problem) problem_ = compared->problem;
    picture.set_marks(std::move(compared->patch), std::move(compared->marks));
    marked_ = compared->state;
  }
  if (marked_ && marked_->panes != panes_revision) {
    picture.set_marks({}, {});
    marked_.reset();
  }
  if (!state) {
    if (later) return;
    comparing_.give_up();
    is_comparing_ = false;
    if (std::exchange(marked_, std::nullopt)) picture.set_marks({}, {});
    return;
  }
  if (is_comparing_ || marked_ == state) return;
  is_comparing_ = true;
  comparing_.begin(
      [compared = panes(), state = *state](const std::stop_token&) { return compare_panes(compared, state); });
}

}  // namespace mes

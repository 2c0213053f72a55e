// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/branch_desk.h"

#include <new>
#include <utility>

namespace mes {

bool BranchDesk::follow(const State& wanted, const std::function<SampleData()>& data) {
  wanted_ = wanted;
  bool is_new = false;
  if (auto done = job_.poll()) {
    take(*std::move(done));
    is_new = true;
  }
  // One at a time: while samples are dragged, a table of some moment is better than none.
  if (job_.is_under_way() || is_current() || failed_ == wanted_) return is_new;
  job_.begin([registry = registry_.share(), state = wanted, samples = data()](const std::stop_token& stop) -> Done {
    try {
      JobControl job(stop);
      auto table = branch_table_of(*registry, samples, state.settings, state.axis, job, state.measures_area);
      if (!table) return {state, nullptr, table.error().message()};
      return {state, std::make_shared<const BranchTable>(std::move(*table)), {}};
    } catch (const Cancelled&) {
      return {state, nullptr, "the computation was stopped"};
    } catch (const std::bad_alloc&) {
      return {state, nullptr, "there is not enough memory"};
    }
  });
  return is_new;
}

void BranchDesk::rest() {
  job_.give_up();
}

void BranchDesk::take(Done done) {
  problem_ = std::move(done.problem);
  failed_.reset();
  if (!done.table) {
    failed_ = done.state;
    return;
  }
  std::optional<std::size_t> chosen;
  if (chosen_ && table_) {
    const AxisBranch& old = table_->branches[*chosen_];
    for (std::size_t row = 0; row < done.table->branches.size() && !chosen; ++row) {
      const AxisBranch& branch = done.table->branches[row];
      if (branch.from.place == old.from.place && branch.to.place == old.to.place) chosen = row;
    }
  }
  chosen_ = chosen;
  table_ = std::move(done.table);
  state_ = done.state;
}

bool BranchDesk::pick(Vec2 place, double reach) {
  if (!is_current()) return false;
  const std::size_t row = branch_near(*table_, place, reach);
  chosen_ = row < table_->branches.size() ? std::optional(row) : std::nullopt;
  return true;
}

}  // namespace mes

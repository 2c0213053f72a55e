// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/latest_branches.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace mes {

bool LatestBranches::follow(const State& wanted, const std::function<SampleData()>& data) {
  const std::shared_ptr<const BranchTable> before = latest_.result();
  const bool is_new = latest_.follow(wanted, [&] {
    return [registry = registry_.share(), state = wanted, samples = data()](JobControl& job) {
      return branch_table_of(*registry, samples, state.settings, state.axis, job, state.measures_area);
    };
  });
  if (chosen_ && latest_.result() != before) {
    const AxisBranch& old = before->branches[*chosen_];
    const std::vector<AxisBranch>& now = table()->branches;
    // Another filter may contract other short branches at an end.
    const double near = kLeastBranch * old.radius_largest;
    const auto same = std::ranges::find_if(now, [&](const AxisBranch& branch) {
      return distance(branch.from.place, old.from.place) <= near && distance(branch.to.place, old.to.place) <= near;
    });
    chosen_ = same == now.end() ? std::nullopt : std::optional(static_cast<std::size_t>(same - now.begin()));
  }
  return is_new;
}

bool LatestBranches::pick(Vec2 place, double reach) {
  if (!is_current()) return false;
  const std::size_t row = branch_near(*table(), place, reach);
  chosen_ = row < table()->branches.size() ? std::optional(row) : std::nullopt;
  return true;
}

}  // namespace mes

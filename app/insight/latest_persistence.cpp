// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/latest_persistence.h"

#include <algorithm>
#include <vector>

namespace mes {

void LatestPersistence::follow(std::uint64_t digest, const std::function<PersistenceInput()>& input) {
  const std::shared_ptr<const PersistenceTable> before = latest_.result();
  latest_.follow(digest, [&] {
    return [registry = registry_.share(), wanted = input()](JobControl& job) {
      return persistence_table_of(*registry, wanted, job);
    };
  });
  if (!chosen_ || latest_.result() == before) return;
  const PersistenceRow& old = before->rows[*chosen_];
  const std::vector<PersistenceRow>& now = table()->rows;
  const auto same = std::ranges::find_if(now, [&](const PersistenceRow& row) {
    return row.is_hole == old.is_hole && row.place == old.place && row.has_edge == old.has_edge &&
           row.edge == old.edge;
  });
  chosen_ = same == now.end() ? std::nullopt : std::optional(static_cast<std::size_t>(same - now.begin()));
}

bool LatestPersistence::pick(Vec2 place, double reach) {
  if (!is_current()) return false;
  chosen_ = row_near(*table(), place, reach);
  return true;
}

}  // namespace mes

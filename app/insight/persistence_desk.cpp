// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/persistence_desk.h"

#include <new>
#include <utility>

namespace mes {

void PersistenceDesk::follow(std::uint64_t document, const std::function<PersistenceInput()>& input) {
  wanted_ = document;
  is_followed_ = true;
  if (auto done = job_.poll()) take(*std::move(done));
  // One at a time: while samples are dragged, a table of some moment is better than none.
  if (job_.is_under_way() || job_.is_ending() || is_current() || failed_ == wanted_) return;
  job_.begin([registry = registry_.share(), document, input = input()](const std::stop_token& stop) -> Done {
    try {
      JobControl job(stop);
      auto table = persistence_table_of(*registry, input, job);
      if (!table) return {document, nullptr, table.error().message()};
      return {document, std::make_shared<const PersistenceTable>(std::move(*table)), {}};
    } catch (const Cancelled&) {
      return {document, nullptr, "the computation was stopped"};
    } catch (const std::bad_alloc&) {
      return {document, nullptr, "there is not enough memory"};
    }
  });
}

void PersistenceDesk::take(Done done) {
  problem_ = std::move(done.problem);
  failed_.reset();
  if (!done.table) {
    failed_ = done.document;
    return;
  }
  std::optional<std::size_t> chosen;
  if (chosen_ && table_) {
    const PersistenceRow& old = table_->rows[*chosen_];
    for (std::size_t i = 0; i < done.table->rows.size() && !chosen; ++i) {
      const PersistenceRow& row = done.table->rows[i];
      if (row.is_hole == old.is_hole && row.place == old.place && row.has_edge == old.has_edge &&
          row.edge == old.edge)
        chosen = i;
    }
  }
  chosen_ = chosen;
  table_ = std::move(done.table);
  state_ = done.document;
}

bool PersistenceDesk::pick(Vec2 place, double reach) {
  if (!is_current()) return false;
  chosen_ = row_near(*table_, place, reach);
  return true;
}

}  // namespace mes

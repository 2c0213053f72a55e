// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina persistence`: births and deaths of components and holes of the alpha complexes, as CSV.
#include <fmt/core.h>
#include <algorithm>

#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/output.h"
#include "app/cli/requests.h"
#include "app/model/persistence_table.h"

namespace mes::cli {

Expected<void> run_persistence(const PersistenceRequest& request, Interruption& interruption) {
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(request.file, request.from, request.reading);
  if (!input) return std::unexpected(input.error());
  JobControl job;
  const auto table = persistence_table_of(input->data, job);
  if (!table) return std::unexpected(table.error());
  const auto longest = std::ranges::find(table->rows, true, &PersistenceRow::is_hole);
  say(fmt::format("{} {}, {} {}{}", table->rows.size() - table->closes.size(),
                  table->rows.size() - table->closes.size() == 1 ? "component" : "components", table->closes.size(),
                  table->closes.size() == 1 ? "hole" : "holes",
                  longest == table->rows.end() ? std::string() : "; the longest " + in_words(*longest)));
  return write_output(request.output, persistence_as_csv(*table), interruption, {input->sources, request.force});
}

}  // namespace mes::cli

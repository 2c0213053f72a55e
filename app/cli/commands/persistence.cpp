// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina persistence`: births and deaths of components and holes of alpha complexes, as CSV.
#include <fmt/core.h>
#include <algorithm>
#include <string_view>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/insight/persistence_table.h"
#include "core/base/counted.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {

Expected<void> run_persistence(const Registry& registry, const PersistenceRequest& request,
                               Interruption& interruption) {
  const auto of = std::ranges::find(kGrowths, request.of, word_of);
  if (of == kGrowths.end()) {
    std::vector<std::string_view> known;
    for (const GrowthOf one : kGrowths) known.push_back(word_of(one));
    return usage_error(fmt::format("--of: {} does not grow; what does is {}", in_quotes(request.of), one_of(known)));
  }
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());
  if (*of == GrowthOf::samples && input->file.data.positions.empty() && !input->file.data.balls.empty())
    say(request.source.file + ": there are balls and no samples; --of own is for balls");
  JobControl job;
  const auto table = persistence_table_of(registry, {input->file.data, *of, input->settings}, job);
  if (!table) return std::unexpected(table.error());
  const auto longest = std::ranges::find(table->rows, true, &PersistenceRow::is_hole);
  const std::string words =
      fmt::format("{}, {}{}", counted(table->rows.size() - table->closes.size(), "component"),
                  counted(table->closes.size(), "hole"),
                  longest == table->rows.end() ? std::string() : "; the longest " + in_words(*longest, table->map));
  const auto csv = persistence_as_csv(*table);
  if (!csv) return std::unexpected(csv.error());
  auto done = write_output(request.output, *csv, interruption, {input->file.sources, request.force});
  if (done) say(words);
  return done;
}

}  // namespace mes::cli

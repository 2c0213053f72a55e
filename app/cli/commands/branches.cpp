// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina branches`: the branches of an axis with their measures, as CSV.
#include <fmt/core.h>
#include <algorithm>
#include <string>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/insight/branch_table.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {

Expected<void> run_branches(const Registry& registry, const BranchesRequest& request, Interruption& interruption) {
  const auto axis = std::ranges::find(kBranchAxes, request.layer, layer_of);
  if (axis == kBranchAxes.end()) {
    std::vector<std::string_view> known;
    for (const BranchAxis one : kBranchAxes) known.push_back(layer_of(one));
    return usage_error(
        fmt::format("--layer: {} has no branches; those that have are {}", in_quotes(request.layer), one_of(known)));
  }
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());
  JobControl job;
  const auto table = branch_table_of(registry, input->file.data, input->settings, *axis, job);
  if (!table) return std::unexpected(table.error());
  const auto csv = branches_as_csv(*table);
  if (!csv) return std::unexpected(csv.error());
  auto done = write_output(request.output, *csv, interruption, {input->file.sources, request.force});
  if (done) say(table->branches.empty() ? "no branch: " + table->reason : kept_in_words(*table));
  return done;
}

}  // namespace mes::cli

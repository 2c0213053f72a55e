// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina repair` and `mesecina decimate`: insert samples where the curve needs them, or remove those it does not
// need.
#include <fmt/core.h>
#include <algorithm>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/input.h"
#include "core/document/commands.h"
#include "core/io/format.h"
#include "core/io/text/text_numbers.h"
#include "core/resampling/decimate.h"
#include "core/resampling/repair.h"

namespace mes::cli {
namespace {

Expected<double> epsilon_of(const ResampleRequest& request) {
  const auto number = parse_number(request.epsilon);
  if (!number || !(*number > 0.0) || !(*number <= 1.0))
    return usage_error(
        fmt::format("--epsilon expects a number above 0 and at most 1, not {}", in_quotes(request.epsilon)));
  return *number;
}

Expected<void> write(const ResampleRequest& request, const SampleData& data, const LoadedFile& input,
                     Interruption& interruption) {
  Document document;
  const auto delta =
      replace_all(document, {.positions = data.positions, .contours = data.contours, .map = input.data.map});
  if (!delta) return std::unexpected(delta.error());
  document.apply(*delta);
  if (!input.data.balls.empty())
    say(fmt::format("balls are left out: POFF holds samples; there were {}", input.data.balls.size()));
  return write_output(request.output, write_poff(document), interruption, {input.sources, request.force, true});
}

}  // namespace

Expected<void> run_repair(const Registry& registry, const ResampleRequest& request, Interruption& interruption) {
  const auto epsilon = epsilon_of(request);
  if (!epsilon) return std::unexpected(epsilon.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(registry, request.file, request.from, request.reading);
  if (!input) return std::unexpected(input.error());
  JobControl job;
  const auto repaired = repair(registry, input->data, *epsilon, job);
  if (!repaired) return std::unexpected(repaired.error());
  if (auto done = write(request, repaired->data, *input, interruption); !done) return done;
  for (const std::string& sentence : repaired->words()) say(sentence);
  return {};
}

Expected<void> run_decimate(const Registry& registry, const ResampleRequest& request, Interruption& interruption) {
  const auto epsilon = epsilon_of(request);
  if (!epsilon) return std::unexpected(epsilon.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(registry, request.file, request.from, request.reading);
  if (!input) return std::unexpected(input.error());
  JobControl job;
  const auto decimated = decimate(registry, input->data, *epsilon, job);
  if (!decimated) return std::unexpected(decimated.error());
  if (auto done = write(request, decimated->data, *input, interruption); !done) return done;
  say(decimated->words());
  return {};
}

}  // namespace mes::cli

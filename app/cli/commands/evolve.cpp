// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina evolve`: samples after some steps of an evolution.
#include <fmt/core.h>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/evolution_runner.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "core/evolutions/evolution.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

/// The first evolution with its defaults; null if there is none.
EvolutionChoice first_evolution(const Registry& registry) {
  const auto all = registry.evolutions().all();
  return {.evolution = all.empty() ? nullptr : all.front()};
}

/// The evolution in the command; missing values are those of `base`.
Expected<EvolutionChoice> choice_of(const Registry& registry, const EvolveRequest& request,
                                    const EvolutionChoice& base) {
  EvolutionChoice out = base;
  if (!request.evolution.empty()) {
    const auto evolution = select_evolution(registry, request.evolution);
    if (!evolution) return std::unexpected(evolution.error());
    out.evolution = *evolution;
  }
  if (!request.seed.empty()) {
    const auto seed = whole_number("--seed", request.seed);
    if (!seed) return std::unexpected(seed.error());
    out.seed = *seed;
  }
  const auto parameters = parameters_of(*out.evolution);
  for (const std::string& setting : request.settings) {
    const auto parsed = parse_setting(setting, parameters);
    if (!parsed) return std::unexpected(parsed.error());
    out.values[parameters[parsed->first]] = parsed->second;
  }
  const EvolutionDescriptor& evolution = out.evolution->descriptor;
  if (const ParameterMove* move = out.evolution->moved_parameter())
    return usage_error(
        fmt::format("{} moves no samples but the parameter {}; give that to compute, render or export by --set",
                    in_quotes(evolution.id), move->parameter.id));
  return out;
}

}  // namespace

Expected<void> run_evolve(const Registry& registry, const EvolveRequest& request, Interruption& interruption) {
  // Rejects unknown names before the file is read.
  if (!request.evolution.empty())
    if (const auto good = choice_of(registry, request, first_evolution(registry)); !good)
      return std::unexpected(good.error());
  const auto steps = whole_number("--steps", request.steps);
  if (!steps) return std::unexpected(steps.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(registry, request.file, request.from, request.reading);
  if (!input) return std::unexpected(input.error());
  const auto of_session = evolution_in(registry, input->session.get());
  if (request.evolution.empty() && !of_session)
    return usage_error("--evolution is required: the file is no session with an evolution");
  const auto choice = choice_of(registry, request, of_session.value_or(first_evolution(registry)));
  if (!choice) return std::unexpected(choice.error());

  Document document;
  const auto read = replace_all(document, input->data);
  if (!read) return std::unexpected(read.error());
  document.apply(*read);
  const auto state = EvolutionRunner(state_of(document), *choice).at(*steps, *steps);
  if (!state) return std::unexpected(state.error());
  const auto written =
      replace_all(document, {.positions = state->positions, .contours = contours_of(*state), .map = input->data.map});
  if (!written) return std::unexpected(written.error());
  document.apply(*written);
  return write_output(request.output, write_poff(document), interruption, {input->sources, request.force, true});
}

}  // namespace mes::cli

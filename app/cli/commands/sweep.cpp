// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina sweep`: moves a parameter through its values, and writes a line of counters and measures for each.
#include <fmt/core.h>
#include <string>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/insight/parameter_sweep.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

Expected<ParameterAnimation> range_of(const Registry& registry, const SweepRequest& request) {
  const std::size_t equals = request.parameter.find('=');
  const std::size_t dots = request.parameter.find("..", equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || dots == std::string::npos)
    return usage_error("--parameter expects NAME=FROM..TO, not " + in_quotes(request.parameter));
  const std::string name = request.parameter.substr(0, equals + 1);
  const auto from = parse_setting(request.parameter.substr(0, dots), registry.parameters(), "--parameter");
  if (!from) return std::unexpected(from.error());
  const auto to = parse_setting(name + request.parameter.substr(dots + 2), registry.parameters(), "--parameter");
  if (!to) return std::unexpected(to.error());
  const auto steps = whole_number("--steps", request.steps, 1, ParameterAnimation::kMostSteps);
  if (!steps) return std::unexpected(steps.error());
  ParameterAnimation out;
  out.parameter = registry.parameters()[from->first];
  out.from = from->second;
  out.to = to->second;
  out.steps = static_cast<int>(*steps);
  return out;
}

}  // namespace

Expected<void> run_sweep(const Registry& registry, const SweepRequest& request, Interruption& interruption) {
  const auto range = range_of(registry, request);
  if (!range) return std::unexpected(range.error());
  if (const auto good = select_layers(registry, request.layers); !good) return std::unexpected(good.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());
  const auto layers = shown_layers(registry, request.layers, input->session());
  if (!layers) return std::unexpected(layers.error());
  Progress progress;
  const std::string name(range->parameter.id);
  JobControl job;
  const auto text = sweep_as_csv(
      registry, {input->file.data, input->settings, *range, *layers},
      [&](double share) { progress.show(name, share); }, job);
  if (!text) return std::unexpected(text.error());
  return write_output(request.output, *text, interruption, {input->file.sources, request.force});
}

}  // namespace mes::cli

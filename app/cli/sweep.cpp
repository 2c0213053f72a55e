// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina sweep`: a parameter goes through its values, and each makes a line of counters and measures.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/cli/input.h"
#include "app/cli/layer_summary.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/requests.h"
#include "app/model/parameter_animation.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/engine.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

/// The cells of one line under their names, which are the paths of these numbers in what `compute` writes; a number that
/// is not there is an empty cell.
using Cells = std::vector<std::pair<std::string, std::string>>;

std::string cell_of(double value) {
  std::string out;
  if (std::isfinite(value)) append_number(out, value);
  return out;
}

Expected<ParameterAnimation> range_of(const SweepRequest& request) {
  const std::size_t equals = request.parameter.find('=');
  const std::size_t dots = request.parameter.find("..", equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || dots == std::string::npos)
    return usage_error("--parameter expects NAME=FROM..TO, not " + in_quotes(request.parameter));
  const std::string name = request.parameter.substr(0, equals + 1);
  const auto from = parse_setting(request.parameter.substr(0, dots), parameter_descriptors(), "--parameter");
  if (!from) return std::unexpected(from.error());
  const auto to = parse_setting(name + request.parameter.substr(dots + 2), parameter_descriptors(), "--parameter");
  if (!to) return std::unexpected(to.error());
  const auto steps = whole_number("--steps", request.steps);
  if (!steps) return std::unexpected(steps.error());
  if (*steps < 1 || *steps > ParameterAnimation::kMostSteps)
    return usage_error(fmt::format("--steps: {} is not between 1 and {}", in_quotes(request.steps),
                                   int{ParameterAnimation::kMostSteps}));
  ParameterAnimation out;
  out.parameter = static_cast<Parameter>(from->first);
  out.from = from->second;
  out.to = to->second;
  out.steps = static_cast<int>(*steps);
  out.start();
  return out;
}

Expected<Cells> cells_of(const FramePatch& patch, const LayerMirror& mirror, const std::vector<LayerIndex>& layers) {
  Cells out;
  for (const LayerIndex layer : layers) {
    const LayerReport& report = patch.reports[layer];
    const std::string id(layer_descriptors()[layer].id);
    const std::string prefix = "layers." + id + '.';
    if (report.state == NodeState::failed || report.state == NodeState::blocked)
      return std::unexpected(Error{ErrorCode::cannot_compute, "layer " + id + " failed: " + report.reason, {}, 0, 0});
    const LayerSummary summary = summarise(mirror, layer);
    for (const PrimitiveKind kind : layer_descriptors()[layer].kinds) {
      out.emplace_back(prefix + std::string(plural_of(kind)),
                       std::to_string(summary.count[static_cast<std::size_t>(kind)]));
      if (kind == PrimitiveKind::segment || kind == PrimitiveKind::arc)
        out.emplace_back(prefix + "length", cell_of(summary.length));
      if (kind == PrimitiveKind::triangle) out.emplace_back(prefix + "area", cell_of(summary.area));
    }
  }
  for (const NodeReport& node : patch.nodes) {
    if (node.state == NodeState::inactive) continue;
    for (const Stat& stat : node.stats) {
      const std::string name = "structures." + node.structure + '.' + stat.key;
      if (const auto* count = std::get_if<std::int64_t>(&stat.value)) out.emplace_back(name, std::to_string(*count));
      if (const auto* measure = std::get_if<double>(&stat.value)) out.emplace_back(name, cell_of(*measure));
    }
  }
  return out;
}

/// Behind the value. The first line says what there is; a later one may lack some of it, or have more, which then has no
/// column.
void add_line(std::string& text, const std::vector<std::string>& columns, const Cells& cells) {
  for (const std::string& column : std::span(columns).subspan(1)) {
    const auto found = std::ranges::find(cells, column, &Cells::value_type::first);
    text += ',';
    if (found != cells.end()) text += found->second;
  }
  text += '\n';
}

}  // namespace

Expected<void> run_sweep(const SweepRequest& request, Interruption& interruption) {
  auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  auto range = range_of(request);
  if (!range) return std::unexpected(range.error());
  const auto layers = select_layers(request.layers);
  if (!layers) return std::unexpected(layers.error());
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(request.source.file, request.source.from, request.source.reading);
  if (!input) return std::unexpected(input.error());
  Document document;
  auto replacement = replace_all(document, input->data);
  if (!replacement) return std::unexpected(replacement.error());

  Progress progress;
  Engine engine({});
  engine.set_want_statistics(true);
  const std::string name(descriptor_of(range->parameter).id);
  LayerMirror mirror;
  std::vector<std::string> columns;
  Cells cells;
  std::string text;
  std::vector<std::shared_ptr<const DocumentDelta>> deltas{
      std::make_shared<const DocumentDelta>(std::move(*replacement))};
  do {
    (*settings)[range->parameter] = range->value();
    engine.post({.deltas = std::exchange(deltas, {}), .settings = *settings, .demand = *layers});
    bool is_complete = false;
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      is_complete = patch->complete;
      if (!is_complete) {
        engine.recycle(std::move(patch));
        continue;
      }
      const auto found = cells_of(*patch, mirror, *layers);
      if (!found) return std::unexpected(found.error());
      cells = *found;
      engine.recycle(std::move(patch));
    }
    // A value that changes nothing has no patch; its line is that of the value before.
    if (!is_complete && columns.empty())
      return std::unexpected(Error{ErrorCode::cannot_compute, "the computation did not finish", {}, 0, 0});
    if (columns.empty()) {
      columns.push_back(name);
      for (const auto& [column, cell] : cells) columns.push_back(column);
      for (const std::string& column : columns) text += (column == columns.front() ? "" : ",") + column;
      text += '\n';
    }
    text += cell_of(range->value());
    add_line(text, columns, cells);
    progress.show(name, static_cast<double>(range->position()) / range->steps);
  } while (range->advance());
  return write_output(request.output, text, interruption, {input->sources, request.force});
}

}  // namespace mes::cli

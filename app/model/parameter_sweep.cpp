// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/parameter_sweep.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <utility>
#include <variant>

#include "app/model/layer_summary.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"
#include "core/io/text_numbers.h"

namespace mes {
namespace {

/// The cells of one line under their names, which are the paths of these numbers in what `compute` writes; a number that
/// is not there is an empty cell.
using Cells = std::vector<std::pair<std::string, std::string>>;

std::string cell_of(double value) {
  std::string out;
  if (std::isfinite(value)) append_number(out, value);
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

void add_line(std::string& text, const std::vector<std::string>& columns, const Cells& cells) {
  for (const std::string& column : std::span(columns).subspan(1)) {
    const auto found = std::ranges::find(cells, column, &Cells::value_type::first);
    text += ',';
    if (found != cells.end()) text += found->second;
  }
  text += '\n';
}

}  // namespace

Expected<std::string> sweep_as_csv(const ParameterSweep& sweep, const std::function<void(double)>& progress,
                                   JobControl& job) {
  const Document document;
  auto delta = replace_all(document, sweep.data);
  if (!delta) return std::unexpected(delta.error());
  Graph graph;
  graph.set_demand(sweep.layers);
  graph.set_want_statistics(true);
  graph.post(std::make_shared<const DocumentDelta>(*std::move(delta)));
  ParameterAnimation range = sweep.range;
  range.start();
  ComputationSettings settings = sweep.settings;
  FramePatch patch;
  LayerMirror mirror;
  std::vector<std::string> columns;
  std::string text;
  do {
    settings[range.parameter] = range.value();
    graph.post_settings(settings);
    if (!graph.run(patch, job)) throw Cancelled{};
    mirror.apply(patch);
    const auto cells = cells_of(patch, mirror, sweep.layers);
    if (!cells) return std::unexpected(cells.error());
    if (columns.empty()) {
      columns.emplace_back(descriptor_of(range.parameter).id);
      for (const auto& [column, cell] : *cells) columns.push_back(column);
      for (const std::string& column : columns) text += (column == columns.front() ? "" : ",") + column;
      text += '\n';
    }
    text += cell_of(range.value());
    add_line(text, columns, *cells);
    if (progress) progress(static_cast<double>(range.position()) / range.steps);
  } while (range.advance());
  return text;
}

void SweepDesk::begin(ParameterSweep sweep) {
  // A sweep that was given up may write to the old one still.
  done_ = std::make_shared<std::atomic<double>>(0.0);
  job_.begin([sweep = std::move(sweep), done = done_](const std::stop_token& stop) -> Expected<std::string> {
    JobControl job(stop);
    const auto failed = [](const char* why) {
      return std::unexpected(Error{ErrorCode::cannot_compute, why, {}, 0, 0});
    };
    try {
      return sweep_as_csv(
          sweep, [&done](double share) { done->store(share, std::memory_order_relaxed); }, job);
    } catch (const Cancelled&) {
      return failed("the computation was stopped");
    } catch (const std::bad_alloc&) {
      return failed("there is not enough memory");
    }
  });
}

}  // namespace mes

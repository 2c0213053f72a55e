// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/parameter_sweep.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "app/layers/layer_summary.h"
#include "core/io/text/text_numbers.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

/// The cells of one line by column name: the path of the number in the output of `compute`. A missing number is an
/// empty cell.
using Cells = std::vector<std::pair<std::string, std::string>>;

std::string cell_of(double value) {
  std::string out;
  if (std::isfinite(value)) append_number(out, value);
  return out;
}

Cells cells_of(const Registry& registry, const Workbench& bench, const std::vector<LayerIndex>& layers) {
  Cells out;
  for (const LayerIndex layer : layers) {
    const LayerDescriptor& descriptor = registry.layers()[layer];
    const std::string prefix = "layers." + std::string(descriptor.id) + '.';
    const LayerSummary summary = summarise(bench.mirror(), layer);
    bool has_length = false;
    for (const PrimitiveKind kind : descriptor.kinds) {
      out.emplace_back(prefix + std::string(plural_of(kind)),
                       std::to_string(summary.count[static_cast<std::size_t>(kind)]));
      const bool is_measured =
          kind == PrimitiveKind::segment || kind == PrimitiveKind::arc || kind == PrimitiveKind::parabola;
      if (is_measured && !std::exchange(has_length, true))
        out.emplace_back(prefix + "length", cell_of(summary.length));
      if (kind == PrimitiveKind::triangle) out.emplace_back(prefix + "area", cell_of(summary.area));
    }
  }
  for (const NodeReport& node : bench.nodes()) {
    if (node.state == NodeState::inactive) continue;
    for (const Stat& stat : node.stats) {
      const std::string name = "structures." + node.structure + '.' + stat.key;
      if (const auto* count = std::get_if<std::int64_t>(&stat.value)) out.emplace_back(name, std::to_string(*count));
      if (const auto* measure = std::get_if<double>(&stat.value)) out.emplace_back(name, cell_of(*measure));
    }
  }
  return out;
}

/// A table that gains columns as lines are added.
class Lines {
 public:
  explicit Lines(std::string_view first_column) : columns_{std::string(first_column)} {}

  void add(double value, const Cells& cells) {
    for (const auto& [column, cell] : cells)
      if (std::ranges::find(columns_, column) == columns_.end()) columns_.push_back(column);
    std::string line = cell_of(value);
    for (const std::string& column : std::span(columns_).subspan(1)) {
      const auto found = std::ranges::find(cells, column, &Cells::value_type::first);
      line += ',';
      if (found != cells.end()) line += found->second;
    }
    lines_.emplace_back(std::move(line), columns_.size());
  }

  std::string text() const {
    std::string out;
    for (const std::string& column : columns_) out += (column == columns_.front() ? "" : ",") + column;
    out += '\n';
    for (const auto& [line, columns] : lines_) {
      out += line;
      out.append(columns_.size() - columns, ',');
      out += '\n';
    }
    return out;
  }

 private:
  std::vector<std::string> columns_;
  std::vector<std::pair<std::string, std::size_t>> lines_;  // with the number of columns at that time
};

}  // namespace

Expected<std::string> sweep_as_csv(const Registry& registry, const ParameterSweep& sweep,
                                   const std::function<void(double)>& progress, JobControl& job) {
  Workbench bench(registry, {.keeps_document = false});
  bench.show(sweep.layers);
  bench.set_want_statistics(true);
  if (auto good = bench.load(sweep.data); !good) return std::unexpected(good.error());
  ParameterAnimation range = sweep.range;
  range.start();
  ComputationSettings settings = sweep.settings;
  Lines lines(range.parameter.id);
  do {
    settings[range.parameter] = range.value();
    bench.choose(settings);
    if (auto good = bench.run_or_throw(job); !good) return std::unexpected(good.error());
    lines.add(range.value(), cells_of(registry, bench, sweep.layers));
    if (progress) progress(static_cast<double>(range.position()) / range.steps);
  } while (range.advance());
  return lines.text();
}

void SweepJob::begin(ParameterSweep sweep) {
  // A new counter, because a sweep that was given up may still write to the old one.
  done_ = std::make_shared<std::atomic<double>>(0.0);
  job_.begin([registry = registry_.share(), sweep = std::move(sweep),
              done = done_](const std::stop_token& stop) -> Expected<std::string> {
    JobControl job(stop);
    const auto failed = [](const char* why) {
      return std::unexpected(Error{ErrorCode::cannot_compute, why, {}, 0, 0});
    };
    try {
      return sweep_as_csv(
          *registry, sweep, [&done](double share) { done->store(share, std::memory_order_relaxed); }, job);
    } catch (const Cancelled&) {
      return failed("the computation was stopped");
    } catch (const std::bad_alloc&) {
      return failed("there is not enough memory");
    }
  });
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "core/base/rng.h"
#include "core/draw/layer_digest.h"
#include "core/evolutions/evolution.h"
#include "core/graph/registry.h"
#include "core/graph/table_columns.h"
#include "core/graph/write_table.h"
#include "core/shapes/shape.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

using Points = std::vector<Vec2>;

double milliseconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Limits the time of a check: slow structures get fewer trials.
class TimeLimit {
 public:
  bool is_over() const { return std::chrono::steady_clock::now() > end_; }

 private:
  std::chrono::steady_clock::time_point end_ = std::chrono::steady_clock::now() + std::chrono::seconds(2);
};

Points ring(std::size_t samples) {
  Points out;
  for (std::size_t i = 0; i < samples; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(samples);
    const double radius = 100.0 + 15.0 * std::cos(5.0 * angle);
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return out;
}

Points uniform(std::size_t samples) {
  Rng rng(3);
  Points out;
  for (std::size_t i = 0; i < samples; ++i) out.push_back({100.0 * rng.uniform(), 100.0 * rng.uniform()});
  return out;
}

struct NamedPoints {
  std::string_view name;
  Points points;
};

std::vector<NamedPoints> degenerate_inputs() {
  std::vector<NamedPoints> out{{"no sample", {}},
                               {"one sample", {{3.0, 4.0}}},
                               {"two samples", {{3.0, 4.0}, {5.0, 4.0}}},
                               {"three samples", {{0.0, 0.0}, {4.0, 0.0}, {1.0, 3.0}}},
                               {"duplicates", {{1.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {2.0, 1.0}, {1.0, 3.0}}}};
  Points line, grid, circle, tiny, large;
  for (int i = 0; i < 12; ++i) line.push_back({static_cast<double>(i), 2.0 * i});
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y) grid.push_back({static_cast<double>(x), static_cast<double>(y)});
  // Integer points on one circle.
  for (const auto& [x, y] :
       {std::pair{0, 65}, {16, 63}, {25, 60}, {33, 56}, {39, 52}, {52, 39}, {56, 33}, {60, 25}, {63, 16}, {65, 0}})
    for (const int sign_x : {-1, 1})
      for (const int sign_y : {-1, 1})
        circle.push_back({static_cast<double>(sign_x * x), static_cast<double>(sign_y * y)});
  for (const Vec2 p : ring(40)) {
    tiny.push_back(0x1p-300 * p);
    large.push_back(0x1p300 * p);
  }
  out.push_back({"samples on a line", std::move(line)});
  out.push_back({"a grid", std::move(grid)});
  out.push_back({"samples on a circle, with duplicates", std::move(circle)});
  out.push_back({"tiny coordinates", std::move(tiny)});
  out.push_back({"large coordinates", std::move(large)});
  return out;
}

/// The rows of a table without columns of row numbers, which depend on history.
std::multiset<std::string> contents_of(const TableColumns& table) {
  std::multiset<std::string> out;
  for (RowNumber row = 0; row < table.rows; ++row) {
    if (!table.is_alive(row)) continue;
    const std::vector<std::string> texts = row_texts(table, row);
    std::string line;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (!table.columns[i].is_reference) line += texts[i] + ';';
    out.insert(std::move(line));
  }
  return out;
}

/// The experiment in its own workbench.
class Subject {
 public:
  Subject(const Registry& registry, const ExperimentContents& added) : added_(added), bench_(registry) {
    bench_.set_want_statistics(true);
    static_cast<void>(bench_.need(std::vector<std::string_view>(added.structures.begin(), added.structures.end())));
    static_cast<void>(bench_.show(std::vector<std::string_view>(added.layers.begin(), added.layers.end())));
  }

  Workbench& bench() { return bench_; }
  void load(const Points& points) {
    SampleData data;
    data.positions = points;
    static_cast<void>(bench_.load(data));
  }
  void run() {
    JobControl job;
    static_cast<void>(bench_.run(job));
  }
  Points points() const {
    Points out;
    for (const SampleSlot slot : bench_.document().slots_in_input_order())
      out.push_back(bench_.document().position(slot));
    return out;
  }
  void edit(Rng& rng, double reach) {
    const std::vector<SampleSlot> slots = bench_.document().slots_in_input_order();
    const std::size_t what = rng.below(4);
    if (slots.size() < 3 || what == 0) {
      static_cast<void>(bench_.insert(std::vector{Vec2{reach * rng.uniform(), reach * rng.uniform()}}));
      return;
    }
    const SampleSlot slot = slots[rng.below(slots.size())];
    const SampleId id = bench_.document().id(slot);
    const Vec2 p = bench_.document().position(slot);
    if (what == 1)
      static_cast<void>(bench_.remove(std::vector{id}));
    else
      static_cast<void>(bench_.move(std::vector{
          std::pair{id, p + Vec2{0.05 * reach * (rng.uniform() - 0.5), 0.05 * reach * (rng.uniform() - 0.5)}}}));
  }

  /// Moves a sample by at most a thousandth of its coordinates.
  void nudge(Rng& rng) {
    const std::vector<SampleSlot> slots = bench_.document().slots_in_input_order();
    const SampleSlot slot = slots[rng.below(slots.size())];
    const Vec2 to = (1.0 + 0.001 * rng.uniform()) * bench_.document().position(slot);
    static_cast<void>(bench_.move(std::vector{std::pair{bench_.document().id(slot), to}}));
  }

  /// The reason why a structure or a layer has no result; empty if it has one.
  std::string failure_of_structure(const std::string& id) const {
    for (const NodeReport& node : bench_.nodes())
      if (node.structure == id && node.state != NodeState::up_to_date) return node.reason.empty() ? "?" : node.reason;
    return {};
  }
  std::string failure_of_layer(const std::string& id) const {
    const auto digest = bench_.digest(id);
    return digest ? std::string() : digest.error().text;
  }
  /// The first difference from another subject with the same samples; empty if they are equal.
  std::string difference_of_structure(const std::string& id, const Subject& other) const {
    const auto mine = bench_.structure(id);
    const auto theirs = other.bench_.structure(id);
    if (!mine && !theirs) return {};
    if (!mine) return "it fails: " + mine.error().text;
    if (!theirs) return "it fails when computed anew: " + theirs.error().text;
    const std::vector<TableColumns> left = (*mine)->table_columns();
    const std::vector<TableColumns> right = (*theirs)->table_columns();
    for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i)
      if (contents_of(left[i]) != contents_of(right[i])) return "table " + left[i].name + " differs";
    const StatList of_left = (*mine)->statistics();
    const StatList of_right = (*theirs)->statistics();
    for (std::size_t i = 0; i < std::min(of_left.size(), of_right.size()); ++i)
      if (of_left[i].value != of_right[i].value) return "statistic " + of_left[i].key + " differs";
    return {};
  }
  std::string difference_of_layer(const std::string& id, const Subject& other) const {
    const auto mine = bench_.digest(id);
    const auto theirs = other.bench_.digest(id);
    if (!mine && !theirs) return {};
    if (!mine) return "it fails: " + mine.error().text;
    if (!theirs) return "it fails when drawn anew: " + theirs.error().text;
    return *mine == *theirs ? std::string() : "the drawing differs";
  }

 private:
  const ExperimentContents& added_;
  Workbench bench_;
};

class Check {
 public:
  Check(const Registry& registry, const ExperimentContents& added) : registry_(registry), added_(added) {}

  std::vector<CheckResult> all() {
    if (!added_.structures.empty() || !added_.layers.empty()) {
      compute_degenerate();
      edit();
      find_numbers();
      draw_side_by_side();
      measure();
    }
    for (const std::string& id : added_.evolutions) evolve(id);
    for (const std::string& id : added_.shapes) make(id);
    std::ranges::stable_sort(out_, {}, [this](const CheckResult& result) { return place_of(result.subject); });
    return std::move(out_);
  }

 private:
  void add(const std::string& subject, std::string property, const std::string& wrong, std::string good) {
    out_.push_back({subject, std::move(property), wrong.empty() ? std::move(good) : wrong, wrong.empty()});
  }
  std::size_t place_of(const std::string& subject) const {
    std::size_t at = 0;
    for (const auto* ids : {&added_.structures, &added_.layers, &added_.evolutions, &added_.shapes})
      for (const std::string& id : *ids) {
        if (id == subject) return at;
        ++at;
      }
    return at;
  }
  /// Calls both functions, for each structure and for each layer.
  template <class OfStructure, class OfLayer>
  void each(OfStructure of_structure, OfLayer of_layer) {
    for (const std::string& id : added_.structures) of_structure(id);
    for (const std::string& id : added_.layers) of_layer(id);
  }

  void compute_degenerate() {
    std::map<std::string, std::string> wrong_structures, wrong_layers;
    const std::vector<NamedPoints> inputs = degenerate_inputs();
    Subject kept(registry_, added_);
    for (const NamedPoints& input : inputs) {
      Subject fresh(registry_, added_);
      for (Subject* subject : {&fresh, &kept}) {
        subject->load(input.points);
        subject->run();
      }
      each(
          [&](const std::string& id) {
            std::string wrong = fresh.failure_of_structure(id);
            if (wrong.empty()) wrong = kept.difference_of_structure(id, fresh);
            if (!wrong.empty()) wrong_structures.try_emplace(id, fmt::format("{}: {}", input.name, wrong));
          },
          [&](const std::string& id) {
            std::string wrong = fresh.failure_of_layer(id);
            if (wrong.empty()) wrong = kept.difference_of_layer(id, fresh);
            if (!wrong.empty()) wrong_layers.try_emplace(id, fmt::format("{}: {}", input.name, wrong));
          });
    }
    const std::string good = fmt::format("ok, {} inputs", inputs.size());
    each([&](const std::string& id) { add(id, "degenerate inputs", wrong_structures[id], good); },
         [&](const std::string& id) { add(id, "degenerate inputs, drawn", wrong_layers[id], good); });
  }

  void edit() {
    constexpr int kEdits = 60;
    std::map<std::string, std::string> wrong_structures, wrong_layers;
    std::map<std::string, int> updates;
    int edits = 0;
    for (const Points& points : {ring(150), uniform(120), degenerate_inputs()[6].points}) {
      Rng rng(5);
      Subject kept(registry_, added_);
      kept.load(points);
      kept.run();
      for (int i = 0; i < kEdits; ++i, ++edits) {
        kept.edit(rng, 100.0);
        kept.run();
        Subject fresh(registry_, added_);
        fresh.load(kept.points());
        fresh.run();
        for (const NodeReport& node : kept.bench().nodes())
          if (node.state == NodeState::up_to_date && !node.rebuilt) ++updates[node.structure];
        each(
            [&](const std::string& id) {
              if (const std::string wrong = kept.difference_of_structure(id, fresh); !wrong.empty())
                wrong_structures.try_emplace(id, fmt::format("edit {}: {}", edits, wrong));
            },
            [&](const std::string& id) {
              if (const std::string wrong = kept.difference_of_layer(id, fresh); !wrong.empty())
                wrong_layers.try_emplace(id, fmt::format("edit {}: {}", edits, wrong));
            });
      }
    }
    each(
        [&](const std::string& id) {
          add(id, "update = rebuild", wrong_structures[id],
              updates[id] == 0 ? fmt::format("ok, {} edits, always rebuilt", edits)
                               : fmt::format("ok, {} edits", edits));
        },
        [&](const std::string& id) {
          add(id, "update = rebuild, drawn", wrong_layers[id], fmt::format("ok, {} edits", edits));
        });
  }

  void find_numbers() {
    Subject subject(registry_, added_);
    subject.load(uniform(2000));
    subject.run();
    each(
        [&](const std::string& id) {
          std::string wrong = subject.failure_of_structure(id);
          std::size_t values = 0;
          const auto structure = subject.bench().structure(id);
          for (const TableColumns& table : structure ? (*structure)->table_columns() : std::vector<TableColumns>())
            for (const TableColumn& column : table.columns) {
              if (column.type != ColumnType::float64 || !wrong.empty()) continue;
              for (RowNumber row = 0; row < table.rows; ++row) {
                if (!table.is_alive(row)) continue;
                std::vector<double> cells(column.width);
                column.copy_row(row, cells.data());
                values += cells.size();
                if (wrong.empty() && std::ranges::any_of(cells, [](double cell) { return std::isnan(cell); }))
                  wrong = fmt::format("{}/{} is not a number in row {}", table.name, column.name, row);
              }
            }
          add(id, "numbers", wrong, fmt::format("ok, {} values", values));
        },
        [&](const std::string& id) {
          std::string wrong = subject.failure_of_layer(id);
          std::uint64_t lost = 0;
          for (const LayerReport& layer : subject.bench().layers())
            if (layer.layer.layer == registry_.find_layer(id)) lost = layer.lost;
          if (wrong.empty() && lost != 0)
            wrong = fmt::format("{} primitives have coordinates that are not finite", lost);
          add(id, "numbers, drawn", wrong, "ok");
        });
  }

  // Draws two graphs at the same time, so that differences reveal data they share.
  void draw_side_by_side() {
    constexpr int kTimes = 8;
    int times = 0;
    std::map<std::string, std::string> wrong;
    const TimeLimit limit;
    Subject alone(registry_, added_);
    alone.load(uniform(3000));
    alone.run();
    for (; times < kTimes && !limit.is_over(); ++times) {
      Subject first(registry_, added_), second(registry_, added_);
      first.load(alone.points());
      second.load(alone.points());
      {
        const std::jthread beside([&second] { second.run(); });
        first.run();
      }
      for (const std::string& id : added_.layers)
        for (const Subject* subject : {&first, &second})
          if (const std::string difference = subject->difference_of_layer(id, alone); !difference.empty())
            wrong.try_emplace(id, difference);
    }
    for (const std::string& id : added_.layers) add(id, "two threads", wrong[id], fmt::format("ok, {} times", times));
  }

  void measure() {
    constexpr std::size_t kSamples = 20'000;
    Subject subject(registry_, added_);
    subject.load(ring(kSamples));
    subject.run();
    std::map<std::string, double> rebuilt, drawn;
    for (const NodeReport& node : subject.bench().nodes()) rebuilt[node.structure] = node.update_ms;
    for (const LayerReport& layer : subject.bench().layers())
      if (layer.layer.layer < registry_.layers().size())
        drawn[registry_.layers()[layer.layer.layer].id] = layer.emit_ms;
    Rng rng(7);
    constexpr int kEdits = 200;
    std::map<std::string, double> updated;
    int edits = 0;
    const TimeLimit limit;
    for (; edits < kEdits && !limit.is_over(); ++edits) {
      subject.nudge(rng);
      subject.run();
      for (const NodeReport& node : subject.bench().nodes()) updated[node.structure] += node.update_ms;
    }
    each(
        [&](const std::string& id) {
          add(id, "time", {},
              fmt::format("{:.0f} ns a sample, {:.1f} us an edit", 1e6 * rebuilt[id] / kSamples,
                          1e3 * updated[id] / std::max(edits, 1)));
        },
        [&](const std::string& id) {
          add(id, "time, drawn", {}, fmt::format("{:.0f} ns a sample", 1e6 * drawn[id] / kSamples));
        });
  }

  /// Checks that state 0 has the default value of the parameter, and that a repeated step gives the same value.
  void move_parameter(const std::string& id, const ParameterMove& move) {
    const EvolutionChoice choice{.evolution = registry_.evolutions().find(id)};
    const double first = move.parameter.default_value;
    std::string wrong;
    int steps = 0;
    if (const auto value = moved_value(move, first, 0, choice.values); !value || *value != first)
      wrong = fmt::format("state 0 is not the value that {} has", move.parameter.id);
    for (std::uint64_t k = 1; k <= 20 && wrong.empty(); ++k, ++steps) {
      const auto value = moved_value(move, first, k, choice.values);
      const auto again = moved_value(move, first, k, choice.values);
      if (!value) break;  // the end of the range is reached
      if (!again || *again != *value) wrong = fmt::format("step {} gives another value when it is made again", k);
    }
    add(id, "steps", wrong, fmt::format("ok, {} steps", steps));
  }

  void evolve(const std::string& id) {
    const auto evolution = registry_.evolutions().find(id);
    if (const ParameterMove* const move = evolution->moved_parameter()) return move_parameter(id, *move);
    std::string wrong;
    int steps = 0;
    double ms = 0.0;
    std::vector<NamedPoints> inputs = degenerate_inputs();
    inputs.push_back({"a ring", ring(300)});
    inputs.push_back({"samples at random", uniform(200)});
    for (const NamedPoints& input : inputs) {
      if (!wrong.empty()) break;
      Workbench bench(registry_);
      static_cast<void>(bench.insert(input.points));
      const EvolutionChoice choice{.evolution = evolution};
      JobControl job;
      const auto begin = begin_evolution(state_of(bench.document()), choice, job);
      if (!begin) {
        wrong = fmt::format("{}: {}", input.name, begin.error().text);
        break;
      }
      EvolutionState state = *begin;
      for (std::uint64_t k = 0; k < 3 && wrong.empty(); ++k, ++steps) {
        Expected<EvolutionState> next = std::unexpected(Error{});
        ms += milliseconds_of([&] { next = next_state(state, k, choice, job); });
        const auto again = next_state(state, k, choice, job);
        if (!next)
          wrong = fmt::format("{}: {}", input.name, next.error().text);
        else if (!again || again->positions != next->positions)
          wrong = fmt::format("{}: the same step gives other positions when it is made again", input.name);
        else
          state = *std::move(next);
      }
    }
    add(id, "steps", wrong, fmt::format("ok, {} steps, {:.2f} ms each", steps, ms / std::max(steps, 1)));
  }

  void make(const std::string& id) {
    const auto shape = registry_.shapes().find(id);
    std::string wrong;
    std::size_t made = 0;
    // Tries the defaults, and each parameter at both ends of its range.
    std::vector<ShapeValues> wishes{values_of(*shape)};
    for (const Parameter& parameter : shape->parameters)
      for (const double end : {parameter.low, parameter.high}) {
        ShapeValues wish = values_of(*shape);
        wish.numbers[parameter] = end;
        wishes.push_back(std::move(wish));
      }
    for (const ShapeValues& wish : wishes) {
      const auto data = make_shape(*shape, {.values = wish, .sampling = {.samples = 100}});
      const auto again = make_shape(*shape, {.values = wish, .sampling = {.samples = 100}});
      if (!data)
        wrong = data.error().text;
      else if (!again || again->positions != data->positions)
        wrong = "the same request gives other samples when it is made again";
      if (!wrong.empty()) break;
      ++made;
    }
    add(id, "samples", wrong, fmt::format("ok, {} requests", made));
  }

  const Registry& registry_;
  const ExperimentContents& added_;
  std::vector<CheckResult> out_;
};

}  // namespace

std::vector<CheckResult> check_experiment(const Registry& registry, const ExperimentContents& added) {
  return Check(registry, added).all();
}

}  // namespace mes

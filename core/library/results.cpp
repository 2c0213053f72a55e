// SPDX-License-Identifier: GPL-3.0-or-later
// Demand, runs and results of a workbench.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/draw/patch.h"
#include "core/engine/theorem_light.h"
#include "core/library/internal/bench.h"

namespace mesecina {
inline namespace v1 {
namespace {

static_assert(std::is_same_v<StatisticValue, mes::StatValue>);

State outer(mes::NodeState state) {
  switch (state) {
    case mes::NodeState::up_to_date: return State::up_to_date;
    case mes::NodeState::computing: return State::unfinished;
    case mes::NodeState::failed: return State::failed;
    case mes::NodeState::blocked: return State::blocked;
    case mes::NodeState::inactive: break;
  }
  return State::inactive;
}

FindingLevel outer(mes::FindingLevel level) {
  switch (level) {
    case mes::FindingLevel::note: return FindingLevel::note;
    case mes::FindingLevel::doubt: return FindingLevel::doubt;
    case mes::FindingLevel::wrong: break;
  }
  return FindingLevel::wrong;
}

Light outer(mes::TheoremLight light) {
  switch (light) {
    case mes::TheoremLight::none: return Light::none;
    case mes::TheoremLight::green: return Light::green;
    case mes::TheoremLight::yellow: return Light::yellow;
    case mes::TheoremLight::red: break;
  }
  return Light::red;
}

StructureReport outer(const mes::NodeReport& node) {
  StructureReport out{.id = node.structure,
                      .state = outer(node.state),
                      .reason = node.reason,
                      .witnesses = all_outer(node.witnesses),
                      .milliseconds = node.update_ms,
                      .touched_rows = node.touched,
                      .is_rebuilt = node.rebuilt,
                      .number_type = std::string(node.kernel)};
  for (const mes::Stat& statistic : node.stats) out.statistics.push_back({statistic.key, statistic.value});
  return out;
}

Finding outer(const mes::Finding& finding, const std::string& structure) {
  return {.structure = structure,
          .level = outer(finding.level),
          .text = finding.text,
          .count = finding.count,
          .places = all_outer(finding.places)};
}

/// Throws the error of a run or a result, with the failed structure and its witnesses.
[[noreturn]] void raise_of(const mes::Error& error, std::span<const mes::NodeReport> nodes,
                           const std::set<std::string, std::less<>>& blamed) {
  if (error.code != mes::ErrorCode::cannot_compute) raise(error);
  const auto is_cause = [&blamed](const mes::NodeReport& node) {
    return node.state == mes::NodeState::failed && (blamed.empty() || blamed.contains(node.structure));
  };
  const auto node = std::ranges::find_if(nodes, is_cause);
  Error::Details details{.code = ErrorCode::cannot_compute, .text = error.text};
  if (node != nodes.end()) {
    details.structure = node->structure;
    details.witnesses = all_outer(node->witnesses);
  }
  throw Error(std::move(details));
}

/// Adds the ids of a structure and of everything it is computed from.
void add_with_inputs(const mes::Registry& registry, std::string_view structure,
                     std::set<std::string, std::less<>>& to) {
  const mes::StructureSpec* const spec = registry.find_structure(structure);
  if (spec == nullptr || !to.insert(spec->id).second) return;
  for (const std::string& input : spec->inputs) add_with_inputs(registry, input, to);
}

std::set<std::string, std::less<>> structures_behind(const mes::Registry& registry, std::string_view layer) {
  std::set<std::string, std::less<>> out;
  const mes::LayerIndex index = registry.find_layer(layer);
  if (index == mes::kNoLayer) return out;
  for (const std::string& structure : registry.layers()[index].structures) add_with_inputs(registry, structure, out);
  return out;
}

std::set<std::string, std::less<>> with_inputs(const mes::Registry& registry, std::string_view structure) {
  std::set<std::string, std::less<>> out;
  add_with_inputs(registry, structure, out);
  return out;
}

/// While it lives, tells the job the current task.
class TaskWatch {
 public:
  TaskWatch(mes::Workbench& bench, Job& job) : bench_(bench) {
    bench_.set_on_task([&job](std::string_view task) { JobAccess::begin_task(job, task); });
  }
  ~TaskWatch() { bench_.set_on_task({}); }
  TaskWatch(const TaskWatch&) = delete;
  TaskWatch& operator=(const TaskWatch&) = delete;

 private:
  mes::Workbench& bench_;
};

std::vector<std::string_view> views_of(std::span<const std::string> ids) {
  return {ids.begin(), ids.end()};
}

}  // namespace

void Workbench::show(std::initializer_list<std::string_view> layers) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.show(layers)); });
}

void Workbench::show(std::span<const std::string> layers) {
  mes::Workbench& bench = impl().bench;
  guarded([&] {
    const std::vector<std::string_view> ids = views_of(layers);
    taken(bench.show(std::span<const std::string_view>(ids)));
  });
}

void Workbench::need(std::initializer_list<std::string_view> structures) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.need(structures)); });
}

void Workbench::need(std::span<const std::string> structures) {
  mes::Workbench& bench = impl().bench;
  guarded([&] {
    const std::vector<std::string_view> ids = views_of(structures);
    taken(bench.need(std::span<const std::string_view>(ids)));
  });
}

void Workbench::want_statistics(bool wanted) {
  impl().bench.set_want_statistics(wanted);
}

void Workbench::want_findings(bool wanted) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { bench.set_want_findings(wanted); });
}

void Workbench::run() {
  Job job;
  run(job);
}

void Workbench::run(Job& job) {
  Impl& to = impl();
  to.clock->begin_run();
  // Tables of structures that the run did not compute have not moved.
  const auto count_computed = [&to] {
    const std::span<const mes::NodeReport> nodes = to.bench.nodes();
    if (nodes.empty()) return;  // the run had no memory for them
    for (std::size_t i = 0; i < to.registry().structures().size(); ++i) to.clock->set_computed(i, nodes[i].computed);
    to.clock->open();
  };
  guarded([&] {
    to.has_gap_before = std::exchange(to.was_stopped, true);
    const TaskWatch watch(to.bench, job);
    const auto done = to.bench.run(JobAccess::control(job));
    to.was_stopped = !done && done.error().code != mes::ErrorCode::cannot_compute;
    count_computed();
    if (!done) raise_of(done.error(), to.bench.nodes(), {});
  });
}

void Workbench::get_ready() {
  Job job;
  get_ready(job);
}

void Workbench::get_ready(Job& job) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { bench.get_ready(JobAccess::control(job)); });
}

std::vector<Table> Workbench::tables(std::string_view structure) const {
  const Impl& of = impl();
  return guarded([&] {
    const auto found = of.bench.structure(structure);
    if (!found) raise_of(found.error(), of.bench.nodes(), with_inputs(of.registry(), structure));
    const auto node = std::ranges::find(of.bench.nodes(), structure, &mes::NodeReport::structure);
    std::vector<Table> out;
    for (mes::TableColumns& table : (*found)->table_columns()) {
      auto access = std::make_shared<TableAccess>();
      access->info = info_of(structure, table);
      access->table = std::move(table);
      access->clock = of.clock;
      access->structure = static_cast<std::size_t>(node - of.bench.nodes().begin());
      access->computed = node->computed;
      access->run = of.clock->run();
      access->is_rebuilt = node->rebuilt || of.has_gap_before;
      out.push_back(Table(std::move(access)));
    }
    return out;
  });
}

Table Workbench::table(std::string_view id) const {
  return guarded([&] {
    const std::string_view structure = id.substr(0, id.find('/'));
    std::vector<Table> all = tables(structure);
    const auto found = std::ranges::find(all, id, [](const Table& table) { return std::string_view(table.id()); });
    if (found == all.end()) refuse_unknown("table", id);
    return *found;
  });
}

Instances Workbench::instances(std::string_view layer, PrimitiveKind kind) const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    if (static_cast<std::size_t>(kind) >= mes::kPrimitiveKinds) refuse("there is no such kind of primitive");
    const auto values = bench.instances(layer, static_cast<mes::PrimitiveKind>(kind));
    if (!values) raise_of(values.error(), bench.nodes(), structures_behind(impl().registry(), layer));
    return Instances{kind, *values};
  });
}

std::string Workbench::digest(std::string_view layer) const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    const auto digest = bench.digest(layer);
    if (!digest) raise_of(digest.error(), bench.nodes(), structures_behind(impl().registry(), layer));
    return digest->text();
  });
}

StatisticValue Workbench::statistic(std::string_view structure, std::string_view key) const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    auto value = bench.statistic(structure, key);
    if (!value) raise_of(value.error(), bench.nodes(), with_inputs(impl().registry(), structure));
    return std::move(*value);
  });
}

double Workbench::number(std::string_view structure, std::string_view key) const {
  const StatisticValue value = statistic(structure, key);
  if (const auto* const real = std::get_if<double>(&value)) return *real;
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  refuse(fmt::format("statistic {} of {} is not one number", key, structure));
}

std::vector<StructureReport> Workbench::structure_reports() const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    std::vector<StructureReport> out;
    for (const mes::NodeReport& node : bench.nodes()) out.push_back(outer(node));
    return out;
  });
}

std::vector<LayerReport> Workbench::layer_reports() const {
  const Impl& of = impl();
  return guarded([&] {
    std::vector<LayerReport> out;
    for (const mes::LayerReport& layer : of.bench.layers())
      out.push_back({.id = std::string(of.registry().layers()[layer.layer.layer].id),
                     .state = outer(layer.state),
                     .reason = layer.reason,
                     .lost = layer.lost});
    return out;
  });
}

std::vector<Finding> Workbench::findings() const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    std::vector<Finding> out;
    for (const mes::NodeReport& node : bench.nodes())
      for (const mes::Finding& finding : node.findings) out.push_back(outer(finding, node.structure));
    return out;
  });
}

Light Workbench::light() const {
  return outer(impl().bench.light());
}

}  // namespace v1
}  // namespace mesecina

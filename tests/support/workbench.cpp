// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/workbench.h"

#include <algorithm>

#include "core/builtins/builtins.h"
#include "core/structures/crust/one_step_crust.h"

namespace mes::test {

std::vector<LayerIndex> all_layers() {
  std::vector<LayerIndex> layers(layer_descriptors().size());
  for (LayerIndex i = 0; i < layers.size(); ++i) layers[i] = i;
  return layers;
}

TestBench::TestBench() {
  graph_.set_demand(all_layers());
  graph_.set_want_statistics(true);
}

TestBench::TestBench(const std::vector<Vec2>& positions) : TestBench() {
  replace(positions);
}

void TestBench::show(std::initializer_list<std::string_view> layers) {
  std::vector<LayerIndex> shown;
  for (const std::string_view layer : layers) shown.push_back(find_layer(layer));
  graph_.set_demand(shown);
}

void TestBench::choose(const ComputationSettings& settings) {
  graph_.post_settings(settings);
  run();
}

void TestBench::replace(const std::vector<Vec2>& positions) {
  SampleData data;
  data.positions = positions;
  load(data);
}

void TestBench::load(const SampleData& data) {
  apply(replace_all(document_, data));
}

void TestBench::insert_balls(const std::vector<Disk>& disks) {
  apply(mes::insert_balls(document_, disks));
}

void TestBench::remove_balls(const std::vector<BallId>& ids) {
  apply(mes::remove_balls(document_, ids));
}

void TestBench::change_ball(BallId id, const Disk& to) {
  apply(change_balls(document_, std::vector{std::pair{id, to}}));
}

void TestBench::insert(const std::vector<Vec2>& positions) {
  apply(insert_samples(document_, positions));
}

void TestBench::remove(const std::vector<SampleId>& ids) {
  apply(remove_samples(document_, ids));
}

void TestBench::move(const std::vector<std::pair<SampleId, Vec2>>& targets) {
  apply(move_samples(document_, targets));
}

void TestBench::undo() {
  apply_all(history_.undo());
}

void TestBench::redo() {
  apply_all(history_.redo());
}

void TestBench::apply(const Expected<DocumentDelta>& delta) {
  REQUIRE(delta.has_value());
  document_.apply(*delta);
  history_.record(*delta);
  graph_.post(std::make_shared<const DocumentDelta>(*delta));
  run();
}

void TestBench::apply_all(const std::vector<DocumentDelta>& deltas) {
  for (const DocumentDelta& delta : deltas) {
    document_.apply(delta);
    graph_.post(std::make_shared<const DocumentDelta>(delta));
  }
  run();
}

void TestBench::run() {
  JobControl job;
  REQUIRE(graph_.run(patch_, job));
  for (const NodeReport& node : patch_.nodes) {
    INFO(node.structure << ": " << node.reason);
    // A source that no layer reads yet is not asked for.
    REQUIRE((node.state == NodeState::up_to_date || node.state == NodeState::inactive));
  }
  for (const LayerReport& layer : patch_.reports) {
    INFO(layer_descriptors()[layer.layer.layer].id << ": " << layer.reason);
    REQUIRE((layer.state == NodeState::up_to_date || layer.state == NodeState::inactive));
  }
  contents_.apply(patch_);
  mirror_.apply(patch_);
  REQUIRE(patch_.document_revision == document_.revision());
}

Provenance TestBench::ask(Vec2 at, double reach, const std::vector<std::string_view>& layers) {
  ProvenanceQuestion question;
  question.at = at;
  question.reach = reach;
  for (const std::string_view layer : layers) question.layers.push_back(find_layer(layer));
  return ask(std::move(question));
}

Provenance TestBench::ask(ProvenanceQuestion question) {
  static std::uint64_t ticket = 0;
  question.ticket = ++ticket;
  graph_.ask(std::move(question));
  run();
  JobControl job;
  std::vector<Provenance> answers;
  graph_.answer(answers, job);
  REQUIRE(answers.size() == 1);
  REQUIRE(answers.front().ticket == ticket);
  return answers.front();
}

std::vector<SampleId> TestBench::ids() const {
  std::vector<SampleId> out;
  for (const SampleSlot slot : document_.slots_in_input_order()) out.push_back(document_.id(slot));
  return out;
}

std::vector<Vec2> TestBench::positions() const {
  std::vector<Vec2> out;
  for (const SampleSlot slot : document_.slots_in_input_order()) out.push_back(document_.position(slot));
  return out;
}

std::vector<BallId> TestBench::ball_ids() const {
  std::vector<BallId> out;
  for (const BallSlot slot : document_.ball_slots_in_input_order()) out.push_back(document_.ball_id(slot));
  return out;
}

std::vector<Disk> TestBench::balls() const {
  std::vector<Disk> out;
  for (const BallSlot slot : document_.ball_slots_in_input_order()) out.push_back(document_.disk(slot));
  return out;
}

const StatValue& TestBench::stat(std::string_view structure, std::string_view key) const {
  for (const NodeReport& node : patch_.nodes) {
    if (node.structure != structure) continue;
    for (const Stat& stat : node.stats)
      if (stat.key == key) return stat.value;
  }
  FAIL("no such statistic: " << structure << " " << key);
  assertion_failed("FAIL throws", __FILE_NAME__, __LINE__);
}

std::int64_t TestBench::count(std::string_view structure, std::string_view key) const {
  return std::get<std::int64_t>(stat(structure, key));
}

double TestBench::measure(std::string_view structure, std::string_view key) const {
  return std::get<double>(stat(structure, key));
}

std::span<const double> TestBench::instances(std::string_view layer, PrimitiveKind kind) const {
  return mirror_.instances(find_layer(layer), kind);
}

std::string TestBench::trouble() const {
  const std::string broken = broken_row(graph_);
  if (!broken.empty()) return broken;
  SampleData reversed{.positions = positions(), .balls = balls()};
  std::ranges::reverse(reversed.positions);
  std::ranges::reverse(reversed.balls);
  TestBench fresh;
  fresh.load(reversed);
  return difference(state(), fresh.state());
}

PlaceEdge place_edge(Vec2 a, Vec2 b) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  return {{a.x, a.y}, {b.x, b.y}};
}

std::set<PlaceEdge> crust_edges(const Graph& graph) {
  const auto& delaunay = graph.structures().get<Delaunay>();
  const auto& crust = graph.structures().get<OneStepCrust>();
  std::set<PlaceEdge> out;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (row.is_alive() && crust.is_crust(edge))
      out.insert(place_edge(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1])));
  }
  return out;
}

}  // namespace mes::test

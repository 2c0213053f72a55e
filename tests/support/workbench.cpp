// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/workbench.h"

#include <algorithm>
#include <array>

#include "core/structures/crust/one_step_crust.h"
#include "tests/support/builtin_layers.h"

namespace mes::test {

std::vector<LayerIndex> all_layers() {
  std::vector<LayerIndex> layers(layer_descriptors().size());
  for (LayerIndex i = 0; i < layers.size(); ++i) layers[i] = i;
  return layers;
}

TestBench::TestBench() {
  bench_.show(all_layers());
  bench_.set_want_statistics(true);
}

TestBench::TestBench(const std::vector<Vec2>& positions) : TestBench() {
  replace(positions);
}

void TestBench::show(std::initializer_list<std::string_view> layers) {
  REQUIRE(bench_.show(layers));
}

void TestBench::show(std::span<const LayerIndex> layers) {
  bench_.show(layers);
}

void TestBench::choose(const ComputationSettings& settings) {
  bench_.choose(settings);
  run();
}

void TestBench::replace(const std::vector<Vec2>& positions) {
  load({.positions = positions});
}

void TestBench::load(const SampleData& data) {
  edit(bench_.load(data));
}

void TestBench::insert_balls(const std::vector<Disk>& disks) {
  REQUIRE(bench_.insert_balls(disks));
  run();
}

void TestBench::remove_balls(const std::vector<BallId>& ids) {
  edit(bench_.remove_balls(ids));
}

void TestBench::change_ball(BallId id, const Disk& to) {
  edit(bench_.change_balls(std::array{std::pair{id, to}}));
}

void TestBench::insert(const std::vector<Vec2>& positions) {
  REQUIRE(bench_.insert(positions));
  run();
}

void TestBench::remove(const std::vector<SampleId>& ids) {
  edit(bench_.remove(ids));
}

void TestBench::move(const std::vector<std::pair<SampleId, Vec2>>& targets) {
  edit(bench_.move(targets));
}

void TestBench::undo() {
  bench_.undo();
  run();
}

void TestBench::redo() {
  bench_.redo();
  run();
}

void TestBench::edit(const Expected<void>& done) {
  REQUIRE(done);
  run();
}

void TestBench::run() {
  JobControl job;
  check(bench_.run(job));
}

void TestBench::check(const Expected<void>& done) {
  INFO((done ? std::string() : done.error().text));
  REQUIRE(done);
  const auto is_good = [](NodeState state) {
    // A source that no layer reads yet is inactive.
    return state == NodeState::up_to_date || state == NodeState::inactive;
  };
  REQUIRE(std::ranges::all_of(bench_.nodes(), is_good, &NodeReport::state));
  REQUIRE(std::ranges::all_of(bench_.layers(), is_good, &LayerReport::state));
  contents_.apply(patch());
  REQUIRE(patch().document_revision == document().revision());
}

Provenance TestBench::ask(Vec2 at, double reach, const std::vector<std::string_view>& layers) {
  ProvenanceQuestion question;
  question.at = at;
  question.reach = reach;
  for (const std::string_view layer : layers) question.layers.push_back(find_layer(layer));
  return ask(std::move(question));
}

Provenance TestBench::ask(ProvenanceQuestion question) {
  JobControl job;
  auto answer = bench_.ask(std::move(question), job);
  check(answer ? Expected<void>() : std::unexpected(answer.error()));
  return *std::move(answer);
}

std::vector<SampleId> TestBench::ids() const {
  std::vector<SampleId> out;
  for (const SampleSlot slot : document().slots_in_input_order()) out.push_back(document().id(slot));
  return out;
}

std::vector<Vec2> TestBench::positions() const {
  std::vector<Vec2> out;
  for (const SampleSlot slot : document().slots_in_input_order()) out.push_back(document().position(slot));
  return out;
}

std::vector<BallId> TestBench::ball_ids() const {
  std::vector<BallId> out;
  for (const BallSlot slot : document().ball_slots_in_input_order()) out.push_back(document().ball_id(slot));
  return out;
}

std::vector<Disk> TestBench::balls() const {
  std::vector<Disk> out;
  for (const BallSlot slot : document().ball_slots_in_input_order()) out.push_back(document().disk(slot));
  return out;
}

std::int64_t TestBench::count(std::string_view structure, std::string_view key) const {
  return std::get<std::int64_t>(bench_.statistic(structure, key).value());
}

double TestBench::measure(std::string_view structure, std::string_view key) const {
  return std::get<double>(bench_.statistic(structure, key).value());
}

std::span<const double> TestBench::instances(std::string_view layer, PrimitiveKind kind) const {
  return mirror().instances(find_layer(layer), kind);
}

std::string TestBench::trouble() const {
  const std::string broken = broken_row(graph());
  if (!broken.empty()) return broken;
  SampleData reversed{.positions = positions(), .balls = balls()};
  std::ranges::reverse(reversed.positions);
  std::ranges::reverse(reversed.balls);
  ComparedBench fresh;
  fresh.load(reversed);
  return difference(state(), fresh.state());
}

ComparedBench::ComparedBench() {
  show({"curve-normals", "medial-axis", "axis-nodes", "interior-voronoi-disks", "label-conflicts", "polar-disks",
        "b-inner-disks"});
}

ComparedBench::ComparedBench(const std::vector<Vec2>& positions) : ComparedBench() {
  replace(positions);
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

// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's guarantees, one by one. Where the moment matters, its thread is held in the `wake` callback, so that
// nothing depends on how fast the machine is.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <map>
#include <mutex>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/engine/engine.h"
#include "core/engine/graph.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

// Holds the engine's thread where it reports; open unless closed.
class Gate {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    ++arrivals_;
    ++passes_;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }
  void close() {
    const std::lock_guard lock(mutex_);
    open_ = false;
    arrivals_ = 0;
  }
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  /// Waits until the engine has reported the end of its last run, which it does a moment after the patch is there:
  /// each run reports its beginning and its end.
  void settle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return passes_ % 2 == 0; });
  }
  /// Waits until the engine stands at the closed gate; when it was idle before, at the beginning of a run.
  void await() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return arrivals_ > 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = true;
  int arrivals_ = 0;
  int passes_ = 0;
};

// A window's side of the engine: document, history, and what the patches have drawn.
class Client {
 public:
  Client() : engine_(std::make_unique<Engine>(builtins(), Engine::Options{[this] { gate_.pass(); }})) {}
  ~Client() { gate_.open(); }

  Engine& engine() { return *engine_; }
  Gate& gate() { return gate_; }
  const Document& document() const { return document_; }
  const LayerContents& contents() const { return contents_; }
  const FramePatch& last() const { return *last_; }
  int patches() const { return patches_; }
  void destroy() { engine_.reset(); }

  void demand(std::vector<std::string_view> ids) {
    std::vector<VariantLayer> layers;
    for (const std::string_view id : ids) layers.emplace_back(find_layer(id));
    engine_->set_demand(layers);
  }
  void replace(const std::vector<Vec2>& positions) {
    SampleData data;
    data.positions = positions;
    post(replace_all(document_, data));
  }
  void insert(const std::vector<Vec2>& positions) { post(insert_samples(document_, positions)); }
  void remove(SampleId id) { post(remove_samples(document_, std::vector{id})); }
  void move(SampleId id, Vec2 to) { post(move_samples(document_, std::vector{std::pair{id, to}})); }
  void undo() {
    for (const DocumentDelta& delta : history_.undo()) {
      document_.apply(delta);
      engine_->post(std::make_shared<const DocumentDelta>(delta));
    }
  }
  /// Takes everything that is ready when all work is done.
  void sync() {
    patches_ = 0;
    while (auto patch = engine_->sync()) {
      contents_.apply(*patch);
      mirror_.apply(*patch);
      ++patches_;
      engine_->recycle(std::move(last_));
      last_ = std::move(patch);
    }
    gate_.settle();
  }
  std::vector<Vec2> positions() const {
    std::vector<Vec2> out;
    for (const SampleSlot slot : document_.slots_in_input_order()) out.push_back(document_.position(slot));
    return out;
  }
  std::vector<SampleId> ids() const {
    std::vector<SampleId> out;
    for (const SampleSlot slot : document_.slots_in_input_order()) out.push_back(document_.id(slot));
    return out;
  }
  /// The layers that the last patch brings something for.
  std::vector<std::string_view> layers_in_last() const {
    std::vector<std::string_view> out;
    for (std::size_t i = 0; i < last_->layer_count; ++i)
      out.push_back(layer_descriptors()[last_->layers[i].layer.layer].id);
    return out;
  }
  const NodeReport& report(std::string_view structure) const {
    const auto found = std::ranges::find(last_->nodes, structure, &NodeReport::structure);
    REQUIRE(found != last_->nodes.end());
    return *found;
  }

 private:
  void post(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    if (delta->is_empty()) return;
    document_.apply(*delta);
    history_.record(*delta);
    engine_->post(std::make_shared<const DocumentDelta>(*delta));
  }

  Document document_;
  History history_;
  Gate gate_;
  LayerContents contents_;
  LayerMirror mirror_;
  std::unique_ptr<FramePatch> last_;
  int patches_ = 0;
  std::unique_ptr<Engine> engine_;  // last: its thread passes the gate
};

// Instances without what depends on history: the numbers that points carry as their scalar.
std::vector<std::vector<double>> drawn(const LayerContents& contents, LayerIndex layer) {
  auto out = contents.sorted(layer);
  if (layer == find_layer("points"))
    for (auto& instance : out) instance.back() = 0.0;
  return out;
}

// Every demanded layer holds what a fresh graph of the same samples draws.
void check_layers(const Client& client, const std::vector<LayerIndex>& layers) {
  TestBench fresh;
  fresh.show(layers);
  fresh.replace(client.positions());
  for (const LayerIndex layer : layers) {
    if (layer == find_layer("last-change")) continue;
    INFO(layer_descriptors()[layer].id);
    const bool same = drawn(client.contents(), layer) == drawn(fresh.contents(), layer);
    CHECK(same);
  }
}

std::vector<Vec2> many(std::size_t n) {
  return uniform_square(n, 5);
}

}  // namespace

TEST_CASE("sync gives the same instances as the graph") {
  Client client;
  client.engine().set_demand(main_layers(all_layers()));
  for (const auto& positions : {benchmark_curve(500), noisy_curve(300), uniform_square(200), std::vector<Vec2>{}}) {
    client.replace(positions);
    client.sync();
    CHECK(client.last().complete);
    CHECK(client.last().document_revision == client.document().revision());
    check_layers(client, all_layers());
  }
}

TEST_CASE("an edit sends changes only, and undo restores the instances") {
  Client client;
  client.engine().set_demand(main_layers(all_layers()));
  client.replace(benchmark_curve(2000));
  client.sync();
  std::vector<std::vector<std::vector<double>>> before;
  for (const LayerIndex layer : all_layers()) before.push_back(drawn(client.contents(), layer));

  const SampleId id = client.ids()[700];
  client.move(id, client.positions()[700] + Vec2{0.3, 0.2});
  client.sync();
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < client.last().layer_count; ++i) {
    // Diagrams of balls, what is made of all poles, what any ball may swallow, unions of what filters keep and of balls
    // along axes of unions, the longest lines of an axis, and the order in which samples and balls come to alpha
    // complexes, are made anew.
    const LayerIndex layer = client.last().layers[i].layer.layer;
    const LayerDescriptor& descriptor = layer_descriptors()[layer];
    if (std::ranges::any_of(descriptor.structures, [](std::string_view s) {
          return s.ends_with("diagram") || s == "p-union" || s == "power-crust" || s.starts_with("cover-") ||
                 s.starts_with("alpha-") || s.ends_with("-ball-filtration") || s.ends_with("-grown-complex") ||
                 s == "center-lines" || s == "lambda-union" || s == "angle-union" || s.ends_with("-scale-union") ||
                 s.ends_with("-skeleton-union");
        }))
      continue;
    for (const KindPatch& kind : client.last().layers[i].kinds) {
      CHECK_FALSE(kind.reset);
      numbers += kind.data.size();
    }
  }
  CHECK(numbers > 0);
  CHECK(numbers < 40 * layer_descriptors().size());
  check_layers(client, all_layers());
  client.insert({{1.0, 2.0}, {3.0, 4.0}});
  client.remove(client.ids()[100]);
  client.sync();
  check_layers(client, all_layers());
  for (int i = 0; i < 3; ++i) client.undo();
  client.sync();
  for (const LayerIndex layer : all_layers()) {
    if (layer == find_layer("last-change")) continue;
    INFO(layer_descriptors()[layer].id);
    const bool same = drawn(client.contents(), layer) == before[layer];
    CHECK(same);
  }
}

TEST_CASE("posts that come while the engine is busy are computed as one step") {
  Client client;
  client.demand({"points", "medial-axis"});
  client.replace(benchmark_curve(300));
  client.sync();
  client.gate().close();
  client.insert({{0.0, 0.0}});
  client.gate().await();
  CHECK(client.engine().status().busy);
  for (int i = 0; i < 60; ++i) client.insert({{1.0 + i, 0.5 * i}});
  client.gate().open();
  client.sync();
  // One patch for the run that was held, one for all the others.
  CHECK(client.patches() == 2);
  CHECK(client.last().document_revision == client.document().revision());
  CHECK(client.contents().count(find_layer("points"), PrimitiveKind::point) == 361);
  check_layers(client, {find_layer("points"), find_layer("medial-axis")});
}

TEST_CASE("poll never waits, and gives patches in order") {
  Client client;
  client.demand({"points"});
  client.replace(benchmark_curve(100));
  client.sync();
  CHECK(client.engine().poll() == nullptr);
  client.gate().close();
  client.insert({{0.0, 0.0}});
  client.gate().await();
  CHECK(client.engine().poll() == nullptr);
  CHECK(client.engine().status().busy);
  client.gate().open();
  std::vector<std::uint64_t> revisions;
  while (revisions.empty() || revisions.back() != client.document().revision()) {
    if (auto patch = client.engine().poll()) revisions.push_back(patch->document_revision);
  }
  CHECK(std::ranges::is_sorted(revisions));
  client.sync();
  CHECK_FALSE(client.engine().status().busy);
  CHECK(client.engine().status().task.empty());
}

TEST_CASE("a layer that comes into demand is sent whole, others are not sent again") {
  Client client;
  client.demand({"points"});
  client.replace(benchmark_curve(200));
  client.sync();
  CHECK(client.layers_in_last() == std::vector<std::string_view>{"points"});
  client.demand({"points", "curve"});
  client.sync();
  CHECK(client.layers_in_last() == std::vector<std::string_view>{"curve"});
  CHECK(client.last().layers[0][PrimitiveKind::segment].reset);
  check_layers(client, {find_layer("points"), find_layer("curve")});
  // Gone, changed behind its back, and back.
  client.demand({"points"});
  client.insert({{0.0, 0.0}});
  client.sync();
  client.demand({"points", "curve"});
  client.sync();
  CHECK(client.last().layers[0][PrimitiveKind::segment].reset);
  check_layers(client, {find_layer("points"), find_layer("curve")});
}

TEST_CASE("hidden layers cost nothing") {
  Client client;
  client.demand({"points"});
  client.replace(benchmark_curve(200));
  client.sync();
  for (const NodeReport& node : client.last().nodes) {
    INFO(node.structure);
    CHECK(node.state == (node.structure == "samples" ? NodeState::up_to_date : NodeState::inactive));
  }
  for (const LayerReport& layer : client.last().reports)
    CHECK(layer.state == (layer.layer == find_layer("points") ? NodeState::up_to_date : NodeState::inactive));
  client.demand({"delaunay"});
  client.sync();
  CHECK(client.report("delaunay").state == NodeState::up_to_date);
  CHECK(client.report("one-step-crust").state == NodeState::inactive);
  client.demand({});
  client.insert({{0.0, 0.0}});
  client.sync();
  CHECK(client.last().layer_count == 0);
  CHECK(client.last().document_revision == client.document().revision());
  CHECK(client.report("delaunay").state == NodeState::inactive);
}

TEST_CASE("a patch whose lists were swapped for older ones calls no hidden layer up to date") {
  Document document;
  Graph graph(builtins());
  const auto delta = replace_all(document, SampleData{.positions = benchmark_curve(50)});
  REQUIRE(delta);
  graph.post(std::make_shared<const DocumentDelta>(*delta));
  JobControl job;
  FramePatch patch;
  RunReport kept;
  const auto run = [&](std::string_view layer) {
    graph.set_demand(std::array{find_layer(layer)});
    REQUIRE(graph.run(patch, job));
    const auto is_up_to_date = [](const LayerReport& report) { return report.state == NodeState::up_to_date; };
    CHECK(std::ranges::count_if(patch.reports, is_up_to_date) == 1);
    CHECK(patch.reports[find_layer(layer)].state == NodeState::up_to_date);
  };
  run("curve");
  std::swap(kept, static_cast<RunReport&>(patch));
  run("points");
  std::swap(kept, static_cast<RunReport&>(patch));
  for (int i = 0; i < 3; ++i) {
    graph.set_want_statistics(i == 1);
    REQUIRE(graph.run(patch, job));
    CHECK(patch.reports[find_layer("curve")].state == NodeState::inactive);
    CHECK(patch.reports[find_layer("points")].state == NodeState::up_to_date);
    std::swap(kept, static_cast<RunReport&>(patch));
  }
}

TEST_CASE("statistics come only while they are wanted") {
  Client client;
  client.demand({"medial-axis"});
  client.replace(benchmark_curve(200));
  client.sync();
  for (const NodeReport& node : client.last().nodes) CHECK(node.stats.empty());
  client.engine().set_want_statistics(true);
  client.sync();
  CHECK(client.patches() == 1);
  CHECK(client.last().layer_count == 0);
  for (const NodeReport& node : client.last().nodes) {
    INFO(node.structure);
    CHECK(node.stats.empty() == (node.state == NodeState::inactive));
  }
  client.insert({{0.0, 0.0}});
  client.sync();
  for (const Stat& stat : client.report("samples").stats)
    if (stat.key == "samples") CHECK(std::get<std::int64_t>(stat.value) == 201);
  client.engine().set_want_statistics(false);
  client.sync();
  for (const NodeReport& node : client.last().nodes) CHECK(node.stats.empty());
}

TEST_CASE("cancel ends a long computation, and resume finishes it") {
  Client client;
  client.demand({"points", "delaunay", "medial-axis"});
  client.sync();
  client.gate().close();
  client.replace(many(20000));
  client.gate().await();
  client.engine().cancel();
  client.gate().open();
  client.sync();
  CHECK(client.engine().status().cancelled);
  CHECK_FALSE(client.engine().status().busy);
  if (client.patches() > 0) CHECK_FALSE(client.last().complete);
  CHECK(client.contents().count(find_layer("delaunay"), PrimitiveKind::segment) == 0);
  // Nothing happens by itself.
  client.sync();
  CHECK(client.patches() == 0);
  client.engine().resume();
  client.sync();
  CHECK_FALSE(client.engine().status().cancelled);
  CHECK(client.last().complete);
  CHECK(client.last().document_revision == client.document().revision());
  check_layers(client, {find_layer("points"), find_layer("delaunay"), find_layer("medial-axis")});
}

TEST_CASE("an edit after cancel goes on with everything") {
  Client client;
  client.demand({"points", "curve"});
  client.replace(benchmark_curve(5000));
  client.sync();
  client.gate().close();
  client.replace(many(20000));
  client.gate().await();
  client.engine().cancel();
  client.gate().open();
  client.sync();
  REQUIRE(client.engine().status().cancelled);
  client.insert({{1.0, 1.0}});
  client.sync();
  CHECK_FALSE(client.engine().status().cancelled);
  CHECK(client.last().complete);
  check_layers(client, {find_layer("points"), find_layer("curve")});
}

TEST_CASE("cancelling idle work changes nothing") {
  Client client;
  client.demand({"curve"});
  client.replace(benchmark_curve(100));
  client.sync();
  client.engine().cancel();
  CHECK_FALSE(client.engine().status().cancelled);
  client.insert({{0.0, 0.0}});
  client.sync();
  CHECK(client.last().complete);
  check_layers(client, {find_layer("curve")});
}

TEST_CASE("replacing everything supersedes what is being computed") {
  Client client;
  client.demand({"points", "delaunay"});
  client.sync();
  client.gate().close();
  client.replace(many(20000));
  client.gate().await();
  client.replace(benchmark_curve(100));
  client.gate().open();
  bool was_cut_short = false;
  while (auto patch = client.engine().sync()) was_cut_short = was_cut_short || !patch->complete;
  CHECK(was_cut_short);
  // The patches above were not kept; the whole picture comes with fresh demand.
  client.demand({});
  client.sync();
  client.demand({"points", "delaunay"});
  client.sync();
  check_layers(client, {find_layer("points"), find_layer("delaunay")});
}

TEST_CASE("settings that are the same stop nothing, and a step is one run") {
  Client client;
  client.demand({"points", "delaunay"});
  client.sync();
  client.gate().close();
  client.replace(many(3000));
  client.gate().await();
  client.engine().set_settings({});
  client.gate().open();
  bool was_cut_short = false;
  while (auto patch = client.engine().sync()) was_cut_short = was_cut_short || !patch->complete;
  CHECK_FALSE(was_cut_short);

  Engine engine(builtins(), {});
  Document document;
  EngineStep step;
  step.demand = {find_layer("points")};
  step.settings.precision = Precision::exact;
  for (int i = 0; i < 50; ++i) {
    const auto delta = insert_samples(document, std::vector{Vec2{0.1 * i, 0.0}});
    document.apply(*delta);
    step.deltas.push_back(std::make_shared<const DocumentDelta>(*delta));
  }
  engine.post(step);
  const auto patch = engine.sync();
  REQUIRE(patch);
  CHECK(patch->complete);
  CHECK(patch->document_revision == document.revision());
  CHECK(patch->layer_count == 1);
  CHECK(engine.sync() == nullptr);
}

TEST_CASE("an engine can be destroyed at any moment") {
  // Busy, at several points of the work.
  for (int i = 0; i < 12; ++i) {
    Client client;
    client.engine().set_demand(main_layers(all_layers()));
    client.sync();
    client.gate().close();
    client.replace(many(20000));
    client.gate().await();
    client.gate().open();
    for (int look = 0; look < i * 20000; ++look) client.engine().status();
    client.destroy();
  }
  // With work that was not taken, with cancelled work, and before it was ever used.
  for (int i = 0; i < 100; ++i) {
    Client client;
    if (i % 3 == 0) continue;
    client.demand({"curve"});
    client.replace(benchmark_curve(50));
    if (i % 3 == 1) client.engine().cancel();
  }
  SUCCEED("all of them came to an end");
}

TEST_CASE("any mixture of edits, undo and demand ends in the right picture") {
  Rng rng(9);
  Client client;
  std::vector<LayerIndex> shown = all_layers();
  client.engine().set_demand(main_layers(shown));
  client.replace(noisy_curve(60));
  for (int step = 0; step < 250; ++step) {
    const std::vector<SampleId> ids = client.ids();
    switch (rng.below(8)) {
      case 0:
      case 1: client.insert({{rng.uniform(-200.0, 200.0), rng.uniform(-200.0, 200.0)}}); break;
      case 2:
        if (ids.size() > 30) client.remove(ids[rng.below(ids.size())]);
        break;
      case 3:
      case 4: {
        const std::size_t at = rng.below(ids.size());
        client.move(ids[at], client.positions()[at] + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)});
        break;
      }
      case 5: client.undo(); break;
      case 6:
        shown.clear();
        for (const LayerIndex layer : all_layers())
          if (rng.below(3) == 0) shown.push_back(layer);
        client.engine().set_demand(main_layers(shown));
        break;
      default: client.engine().set_want_statistics(rng.below(2) == 0);
    }
    // Often several of these fall into one run.
    if (rng.below(3) == 0) continue;
    INFO("step " << step);
    client.sync();
    check_layers(client, shown);
  }
}

TEST_CASE("answering a question is not computing: the engine is not busy with it, and sends no layer again") {
  Client client;
  client.demand({"points"});
  client.replace({{0, 0}, {1, 0}, {0, 1}});
  client.sync();
  client.engine().ask({7, {1.0, 0.1}, 0.2, {find_layer("points")}, ProvenanceWish::shape});
  CHECK_FALSE(client.engine().status().busy);
  const auto patch = client.engine().sync();
  REQUIRE(patch);
  CHECK(patch->layer_count == 0);
  const std::vector<Provenance> answers = client.engine().take_answers();
  REQUIRE(answers.size() == 1);
  const Provenance& answer = answers.front();
  CHECK(answer.ticket == 7);
  // The shape alone was wanted.
  REQUIRE(answer.lines.size() == 1);
  CHECK(answer.lines.front().text.empty());
  REQUIRE(answer.lines.front().shapes.size() == 1);
  CHECK(answer.lines.front().shapes.front().values[0] == 1.0);
  CHECK(client.engine().take_answers().empty());
  CHECK_FALSE(client.engine().status().cancelled);
  // With nothing being computed there is nothing to cancel.
  client.engine().ask({8, {5.0, 5.0}, 0.2, {find_layer("points")}, ProvenanceWish::shape});
  client.engine().cancel();
  CHECK_FALSE(client.engine().status().cancelled);
  REQUIRE(client.engine().sync());
  const std::vector<Provenance> next = client.engine().take_answers();
  REQUIRE(next.size() == 1);
  CHECK(next.front().lines.empty());
}

TEST_CASE("questions with different wishes are all answered, of those with one wish the last") {
  Client client;
  client.demand({"points"});
  client.replace({{0, 0}, {1, 0}, {0, 1}});
  client.sync();
  const std::vector<VariantLayer> points{find_layer("points")};
  // The engine may have answered some before the others come; those are answered all the same.
  client.engine().ask({1, {1.0, 0.1}, 0.2, points, ProvenanceWish::sources_of_values, 0.0, 1.0});
  client.engine().ask({2, {1.0, 0.1}, 0.2, points, ProvenanceWish::story});
  client.engine().ask({3, {0.4, 0.3}, 0.0, {}, ProvenanceWish::insertion});
  client.engine().ask({4, {1.0, 0.1}, 0.2, points, ProvenanceWish::shape});
  client.engine().ask({5, {0.0, 0.1}, 0.2, points, ProvenanceWish::shape});
  while (client.engine().sync()) continue;
  std::map<std::uint64_t, Provenance> answers;
  for (Provenance& answer : client.engine().take_answers()) answers.emplace(answer.ticket, std::move(answer));
  CHECK(answers.contains(1));
  REQUIRE(answers.contains(2));
  CHECK_FALSE(answers[2].lines.empty());
  CHECK(answers.contains(3));
  REQUIRE(answers.contains(5));
  REQUIRE(answers[5].lines.size() == 1);
  CHECK(answers[5].lines.front().shapes.front().values[0] == 0.0);
}

TEST_CASE("an edit does not wait for an answer, which is then about what the edit made") {
  Client client;
  client.demand({"points"});
  client.replace({{0, 0}, {1, 0}, {0, 1}});
  client.sync();
  client.gate().settle();
  client.gate().close();
  client.engine().ask({1, {}, 0.0, {find_layer("points")}, ProvenanceWish::sources_of_values, 0.0, 1000.0});
  client.gate().await();  // it is about to answer
  client.move(client.document().id(client.document().slots_in_input_order()[1]), {5.0, 7.0});
  client.gate().open();
  while (client.engine().sync()) continue;
  const std::vector<Provenance> answers = client.engine().take_answers();
  REQUIRE(answers.size() == 1);
  REQUIRE(answers.front().lines.size() == 1);
  const std::vector<ProvenanceShape>& shapes = answers.front().lines.front().shapes;
  CHECK(std::ranges::any_of(shapes, [](const ProvenanceShape& shape) { return shape.values[0] == 5.0; }));
  CHECK(std::ranges::none_of(shapes, [](const ProvenanceShape& shape) { return shape.values[0] == 1.0; }));
}

TEST_CASE("a question whose answer is stopped stays asked, and is answered after the next run") {
  Graph graph{builtins()};
  Document document;
  std::vector<Vec2> samples;
  constexpr int kSide = 80;
  for (int i = 0; i < kSide * kSide; ++i)
    samples.push_back({static_cast<double>(i % kSide), static_cast<double>(i / kSide)});
  const auto delta = replace_all(document, {samples, {}});
  REQUIRE(delta);
  graph.post(std::make_shared<const DocumentDelta>(*delta));
  const std::vector<VariantLayer> demand{find_layer("points")};
  graph.set_demand(demand);
  FramePatch patch;
  JobControl job;
  REQUIRE(graph.run(patch, job));
  graph.ask({1,
             {0.0, 0.0},
             0.0,
             demand,
             ProvenanceWish::sources_of_values,
             -std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()});
  graph.ask({2, {1.1, 1.0}, 0.2, demand, ProvenanceWish::shape});
  JobControl stopped;
  stopped.stop_at_look(3);
  std::vector<Provenance> first;
  graph.answer(first, stopped);
  REQUIRE(first.size() == 1);
  CHECK(first.front().ticket == 2);
  CHECK(graph.has_questions());
  JobControl unstopped;
  std::vector<Provenance> second;
  graph.answer(second, unstopped);
  REQUIRE(second.size() == 1);
  CHECK(second.front().ticket == 1);
  REQUIRE_FALSE(second.front().lines.empty());
  CHECK_FALSE(graph.has_questions());
}

TEST_CASE("an explanation that looks at all rows is stopped among them, and is given after the next run") {
  Graph graph{builtins()};
  Document document;
  SampleData data;
  for (int i = 0; i < 3000; ++i) data.balls.push_back({{static_cast<double>(i), 0.0}, 0.75});
  const auto delta = replace_all(document, data);
  REQUIRE(delta);
  graph.post(std::make_shared<const DocumentDelta>(*delta));
  const std::vector<VariantLayer> demand{find_layer("b-inner-disks"), find_layer("b-union-boundary"),
                                         find_layer("b-v-points")};
  graph.set_demand(demand);
  FramePatch patch;
  JobControl job;
  REQUIRE(graph.run(patch, job));
  const auto ask = [&](VariantLayer layer, Vec2 at) { graph.ask({1, at, 0.1, std::vector<VariantLayer>{layer}}); };
  for (const VariantLayer layer : demand) {
    CAPTURE(layer_descriptors()[layer.layer].id);
    // The crossing of the circles of the last two balls: what each of the layers shows is there.
    const Vec2 at{2998.5, std::sqrt(0.75 * 0.75 - 0.25)};
    ask(layer, at);
    JobControl unstopped;
    std::vector<Provenance> expected;
    graph.answer(expected, unstopped);
    REQUIRE(expected.size() == 1);
    REQUIRE_FALSE(expected.front().lines.empty());
    std::vector<Provenance> got;
    std::int64_t looks = 0;
    ask(layer, at);
    while (graph.has_questions()) {
      REQUIRE(got.empty());
      JobControl stopped;
      stopped.stop_at_look(++looks);
      graph.answer(got, stopped);
    }
    REQUIRE(got.size() == 1);
    CHECK(got.front().lines.size() == expected.front().lines.size());
    CHECK(got.front().lines.front().text == expected.front().lines.front().text);
    // At least each thousand of some 6,000 v-points.
    CHECK(looks > 6);
  }
}

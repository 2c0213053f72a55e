// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/workbench/workbench.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

std::vector<Vec2> samples_of_ellipse(int count) {
  std::vector<Vec2> out;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    out.push_back({2.0 * std::cos(t), std::sin(t)});
  }
  return out;
}

std::vector<SampleId> ids_of(const Document& document) {
  std::vector<SampleId> out;
  for (const SampleSlot slot : document.slots_in_input_order()) out.push_back(document.id(slot));
  return out;
}

std::string digest_in(const Workbench& bench, std::string_view layer) {
  const auto digest = bench.digest(layer);
  REQUIRE(digest);
  return digest->text();
}

std::size_t segments_in(const Workbench& bench, std::string_view layer) {
  const auto values = bench.instances(layer, PrimitiveKind::segment);
  REQUIRE(values);
  return values->size() / stride_of(PrimitiveKind::segment);
}

/// The digest of a layer in the last line of a file of digests, each line of which describes one state.
std::string last_digest(const std::string& file, const std::string& layer) {
  std::ifstream in(file);
  std::string line;
  for (std::string next; std::getline(in, next);) line = next;
  const std::string key = '"' + layer + "\":\"";
  const std::size_t at = line.find(key);
  REQUIRE(at != std::string::npos);
  return line.substr(at + key.size(), 32);
}

template <class T>
void check_refused(const Expected<T>& result, ErrorCode code, std::string_view text) {
  REQUIRE_FALSE(result);
  CHECK(result.error().code == code);
  CHECK(result.error().text == text);
}

/// Fails while the document has more than three samples.
class Fussy final : public Structure {
 public:
  explicit Fussy(Samples& samples) : Structure("fussy", {&samples}), samples_(samples) {}
  void rebuild(JobControl&) override {
    if (samples_.count() > 3) throw GeometryError("there are too many samples");
  }
  bool update(JobControl&) override { return false; }
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override { return {}; }

 private:
  Samples& samples_;
};

}  // namespace

TEST_CASE("a workbench computes what is shown and needed, and follows edits, undo and redo") {
  JobControl job;
  Workbench bench(builtins());
  const auto ids = bench.insert(samples_of_ellipse(40));
  REQUIRE(ids);
  CHECK(*ids == ids_of(bench.document()));
  REQUIRE(bench.show({"medial-axis", "curve"}));
  REQUIRE(bench.need({"one-step-crust"}));
  REQUIRE(bench.run(job));
  CHECK(segments_in(bench, "curve") == 40);
  const std::string whole = digest_in(bench, "medial-axis");
  bench.get_ready(job);
  CHECK(digest_in(bench, "medial-axis") == whole);

  REQUIRE(bench.move(std::array{std::pair{ids->front(), Vec2{2.1, 0.01}}}));
  REQUIRE(bench.run(job));
  const std::string moved = digest_in(bench, "medial-axis");
  CHECK(moved != whole);
  REQUIRE(bench.remove(std::array{ids->at(5), ids->at(6)}));
  REQUIRE(bench.run(job));
  CHECK(bench.document().sample_count() == 38);

  // The same document in a fresh workbench has the same layers.
  Workbench fresh(builtins());
  REQUIRE(fresh.load(data_of(bench.document())));
  REQUIRE(fresh.show({"medial-axis", "curve"}));
  REQUIRE(fresh.run(job));
  for (const char* layer : {"medial-axis", "curve"}) CHECK(digest_in(fresh, layer) == digest_in(bench, layer));

  CHECK(bench.undo());
  REQUIRE(bench.run(job));
  CHECK(digest_in(bench, "medial-axis") == moved);
  CHECK(bench.undo());
  REQUIRE(bench.run(job));
  CHECK(digest_in(bench, "medial-axis") == whole);
  CHECK(bench.redo());
  REQUIRE(bench.run(job));
  CHECK(digest_in(bench, "medial-axis") == moved);
  CHECK(bench.undo());
  CHECK(bench.undo());
  CHECK_FALSE(bench.undo());
  CHECK(bench.document().is_empty());
}

TEST_CASE("edits between the begin and the end of a step are undone together") {
  Workbench bench(builtins());
  bench.begin_step("Two of them");
  REQUIRE(bench.insert(std::array{Vec2{0.0, 0.0}}));
  REQUIRE(bench.insert_balls(std::array{Disk{{1.0, 0.0}, 2.0}}));
  bench.end_step();
  CHECK(bench.history().undo_name() == "Two of them");
  CHECK(bench.undo());
  CHECK(bench.document().is_empty());
}

TEST_CASE("balls are inserted, changed and removed") {
  JobControl job;
  Workbench bench(builtins());
  const auto ids = bench.insert_balls(std::array{Disk{{0.0, 0.0}, 2.0}, Disk{{1.0, 0.0}, 2.0}});
  REQUIRE(ids);
  REQUIRE(ids->size() == 2);
  REQUIRE(bench.need({"b-union"}));
  bench.set_want_statistics(true);
  REQUIRE(bench.run(job));
  CHECK(std::get<std::int64_t>(*bench.statistic("b-union", "components")) == 1);
  REQUIRE(bench.change_balls(std::array{std::pair{ids->front(), Disk{{-10.0, 0.0}, 2.0}}}));
  REQUIRE(bench.run(job));
  CHECK(std::get<std::int64_t>(*bench.statistic("b-union", "components")) == 2);
  REQUIRE(bench.remove_balls(std::array{ids->front()}));
  REQUIRE(bench.run(job));
  CHECK(std::get<std::int64_t>(*bench.statistic("b-union", "components")) == 1);
}

TEST_CASE("a workbench reads a session as every command does") {
  JobControl job;
  Workbench bench(builtins());
  bench.set_precision(Precision::exact);
  const auto file = bench.open("tests/data/edited_bean.json", job);
  REQUIRE(file);
  CHECK(file->format == "session");
  CHECK(bench.settings().precision == Precision::fast);
  CHECK(bench.document().sample_count() == file->data.positions.size());
  REQUIRE(bench.show({"medial-axis", "interior-voronoi-disks", "points"}));
  REQUIRE(bench.run(job));
  for (const char* layer : {"medial-axis", "interior-voronoi-disks", "points"})
    CHECK(digest_in(bench, layer) == last_digest("tests/data/edited_bean.digests", layer));
}

TEST_CASE("a workbench reads bytes, and a file that it cannot read changes nothing") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.open_bytes("POFF 3 0 0\n0 0\n1 0\n0 1\n", "three.poff", job));
  CHECK(bench.document().sample_count() == 3);
  const auto revision = bench.document().revision();
  const auto missing = bench.open("tests/data/no_such_file.poff", job);
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::bad_input);
  CHECK(missing.error().file == "tests/data/no_such_file.poff");
  const auto broken = bench.open_bytes("POFF 3 0 0\n0 0\n1 zero\n0 1\n", "three.poff", job);
  REQUIRE_FALSE(broken);
  CHECK(broken.error().line == 3);
  CHECK(bench.document().revision() == revision);
}

TEST_CASE("an edit that is refused changes nothing") {
  Workbench bench(builtins());
  const auto ids = bench.insert(samples_of_ellipse(5));
  REQUIRE(ids);
  const auto revision = bench.document().revision();
  CHECK_FALSE(bench.insert(std::array{Vec2{std::numeric_limits<double>::infinity(), 0.0}}));
  CHECK_FALSE(bench.remove(std::array{SampleId{1'000}}));
  CHECK_FALSE(bench.insert_balls(std::array{Disk{{0.0, 0.0}, -1.0}}));
  CHECK(bench.document().revision() == revision);
  CHECK(bench.history().position() == 1);
}

TEST_CASE("parameters and number types are set by name, and checked") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.insert(samples_of_ellipse(60)));
  REQUIRE(bench.show({"lambda-medial-axis"}));
  REQUIRE(bench.run(job));
  const std::size_t all = segments_in(bench, "lambda-medial-axis");
  REQUIRE(bench.set("lambda-limit", 0.9));
  REQUIRE(bench.run(job));
  CHECK(segments_in(bench, "lambda-medial-axis") < all);
  REQUIRE(bench.set("lambda-limit", -1.0));  // a limit goes no further than its range
  CHECK(bench.settings()[Parameter::lambda_limit] == 0.0);
  REQUIRE(bench.run(job));
  CHECK(segments_in(bench, "lambda-medial-axis") == all);

  const ComputationSettings before = bench.settings();
  check_refused(bench.set("lambda", 0.5), ErrorCode::usage, "unknown parameter \"lambda\"");
  check_refused(bench.set("pole-propagation", 0.5), ErrorCode::usage,
                "parameter pole-propagation expects a whole number from 0 to 1, not 0.5");
  check_refused(bench.set("a-scale", 1000.0), ErrorCode::usage,
                "parameter a-scale expects a number from 0.01 to 100, not 1000");
  CHECK_FALSE(bench.set("lambda-limit", std::numeric_limits<double>::quiet_NaN()));
  check_refused(bench.set_precision("quadruple"), ErrorCode::usage, "unknown number type \"quadruple\"");
  CHECK(bench.settings() == before);
  REQUIRE(bench.set_precision("exact-roots"));
  CHECK(bench.settings().precision == Precision::exact_roots);
}

TEST_CASE("a structure is computed when it is needed, without any layer") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.insert(samples_of_ellipse(30)));
  bench.need<MedialAxis>();
  REQUIRE(bench.run(job));
  CHECK(bench.patch().layer_count == 0);
  const auto crust = bench.structure("one-step-crust");
  REQUIRE(crust);
  CHECK(*crust == &bench.get<OneStepCrust>());
  CHECK(bench.get<Delaunay>().site_rows() == 30);
  check_refused(bench.structure("b-union"), ErrorCode::usage, "structure b-union was not computed");
  check_refused(bench.structure("b-onion"), ErrorCode::usage, "unknown structure \"b-onion\"");
  check_refused(bench.statistic("one-step-crust", "crust_edges"), ErrorCode::usage,
                "structure one-step-crust has no statistics");
  bench.set_want_statistics(true);
  REQUIRE(bench.run(job));
  CHECK(std::get<std::int64_t>(*bench.statistic("one-step-crust", "crust_edges")) == 30);
  check_refused(bench.statistic("one-step-crust", "edges_of_crust"), ErrorCode::usage,
                "unknown statistic \"edges_of_crust\"");

  // What is not needed any more is not computed.
  REQUIRE(bench.need({"delaunay"}));
  REQUIRE(bench.run(job));
  CHECK(bench.structure("delaunay"));
  CHECK_FALSE(bench.structure("medial-axis"));
  check_refused(bench.need({"delaunay", "voronoi"}), ErrorCode::usage, "unknown structure \"voronoi\"");
}

TEST_CASE("layers that are unknown, hidden or not kept have no instances") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.insert(samples_of_ellipse(30)));
  check_refused(bench.show({"curve", "curl"}), ErrorCode::usage, "unknown layer \"curl\"");
  check_refused(bench.digest("curl"), ErrorCode::usage, "unknown layer \"curl\"");
  REQUIRE(bench.show({"curve"}));
  check_refused(bench.digest("curve"), ErrorCode::usage, "layer curve was not computed");
  REQUIRE(bench.run(job));
  CHECK(segments_in(bench, "curve") == 30);
  check_refused(bench.instances("medial-axis", PrimitiveKind::segment), ErrorCode::usage,
                "layer medial-axis was not computed");
  REQUIRE(bench.show({"medial-axis"}));
  REQUIRE(bench.run(job));
  CHECK_FALSE(bench.digest("curve"));

  Workbench lean(builtins(), {.keeps_history = false, .keeps_instances = false});
  REQUIRE(lean.insert(samples_of_ellipse(30)));
  REQUIRE(lean.show({"curve"}));
  REQUIRE(lean.run(job));
  CHECK(lean.patch().layer_count == 1);
  check_refused(lean.digest("curve"), ErrorCode::usage, "this workbench keeps no instances");
  CHECK_FALSE(lean.undo());
}

TEST_CASE("a run that is stopped changes no instance, and the next one completes it") {
  const std::vector<Vec2> points = samples_of_ellipse(3000);
  Workbench bench(builtins());
  REQUIRE(bench.insert(std::span(points).first(2000)));
  REQUIRE(bench.show({"curve"}));
  JobControl job;
  REQUIRE(bench.run(job));
  const std::string before = digest_in(bench, "curve");

  REQUIRE(bench.load({.positions = points}));
  JobControl stopped;
  stopped.stop_at_look(1);
  check_refused(bench.run(stopped), ErrorCode::cancelled, "the computation was stopped");
  CHECK(digest_in(bench, "curve") == before);
  check_refused(bench.structure("delaunay"), ErrorCode::cancelled, "the computation was stopped");
  JobControl again;
  again.stop_at_look(1);
  CHECK_THROWS_AS(bench.run_or_throw(again), Cancelled);

  REQUIRE(bench.run(job));
  CHECK(segments_in(bench, "curve") == 3000);
  CHECK(bench.structure("delaunay"));
}

TEST_CASE("a failed structure is the error of the run, and the rest can be read") {
  Registry registry;
  add_builtins(registry);
  registry.add_structure<Fussy, Samples>();
  registry.add_layer([](const StructureSet& set) {
    return Layer{.descriptor = {.id = "of-fussy"}, .structures = {&set.get<Fussy>()}, .parts = {}};
  });
  JobControl job;
  Workbench bench(registry);
  const auto ids = bench.insert(samples_of_ellipse(4));
  REQUIRE(ids);
  REQUIRE(bench.show({"points", "of-fussy"}));
  check_refused(bench.run(job), ErrorCode::cannot_compute, "structure fussy failed: there are too many samples");
  check_refused(bench.structure("fussy"), ErrorCode::cannot_compute,
                "structure fussy failed: there are too many samples");
  check_refused(bench.digest("of-fussy"), ErrorCode::cannot_compute,
                "layer of-fussy failed: there are too many samples");
  CHECK(bench.instances("points", PrimitiveKind::point)->size() == 4 * stride_of(PrimitiveKind::point));
  REQUIRE(bench.remove(std::array{ids->front()}));
  REQUIRE(bench.run(job));
  CHECK(bench.structure("fussy"));
}

TEST_CASE("no, one and two samples are no error") {
  JobControl job;
  for (int count = 0; count <= 2; ++count) {
    Workbench bench(builtins());
    std::vector<LayerIndex> all(builtins().layers().size());
    for (LayerIndex i = 0; i < all.size(); ++i) all[i] = i;
    bench.show(all);
    bench.set_want_findings(true);
    bench.set_want_statistics(true);
    REQUIRE(bench.insert(samples_of_ellipse(count)));
    REQUIRE(bench.run(job));
    CHECK(bench.instances("points", PrimitiveKind::point)->size() / stride_of(PrimitiveKind::point) ==
          static_cast<std::size_t>(count));
    CHECK(segments_in(bench, "medial-axis") == 0);
  }
}

TEST_CASE("the light is that of the findings, when they are wanted") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.insert(samples_of_ellipse(100)));
  REQUIRE(bench.show({"medial-axis"}));
  REQUIRE(bench.run(job));
  CHECK(bench.light() == TheoremLight::none);
  bench.set_want_findings(true);
  REQUIRE(bench.run(job));
  CHECK(bench.light() == TheoremLight::green);
}

TEST_CASE("a workbench answers what lies at a place, in the present document") {
  JobControl job;
  Workbench bench(builtins());
  REQUIRE(bench.insert(std::array{Vec2{0.0, 0.0}, Vec2{4.0, 0.0}, Vec2{0.0, 3.0}}));
  REQUIRE(bench.show({"points"}));
  const ProvenanceQuestion question{
      .at = {4.01, 0.0}, .reach = 0.1, .layers = {builtins().find_layer("points")}, .wish = ProvenanceWish::shape};
  auto answer = bench.ask(question, job);
  REQUIRE(answer);
  REQUIRE(answer->lines.size() == 1);
  CHECK(answer->lines[0].shapes.at(0).values[0] == 4.0);
  REQUIRE(bench.remove(std::array{ids_of(bench.document())[1]}));
  answer = bench.ask(question, job);
  REQUIRE(answer);
  CHECK(answer->lines.empty());
  JobControl stopped;
  stopped.stop_at_look(1);
  REQUIRE(bench.insert(samples_of_ellipse(2000)));
  REQUIRE(bench.show({"points", "curve"}));
  check_refused(bench.ask(question, stopped), ErrorCode::cancelled, "the computation was stopped");
}

TEST_CASE("a workbench without a document computes what is loaded, and refuses other edits") {
  JobControl job;
  Workbench keeper(builtins());
  Workbench bench(builtins(), {.keeps_document = false});
  for (Workbench* one : {&keeper, &bench}) REQUIRE(one->show({"medial-axis", "b-union-boundary"}));
  for (const int count : {40, 25, 60}) {
    const SampleData data{.positions = samples_of_ellipse(count),
                          .balls = {Disk{{0.0, 0.0}, 2.0}, Disk{{1.0, 0.0}, 0.1 * count}}};
    for (Workbench* one : {&keeper, &bench}) {
      REQUIRE(one->load(data));
      REQUIRE(one->run(job));
    }
    for (const char* layer : {"medial-axis", "b-union-boundary"})
      CHECK(digest_in(bench, layer) == digest_in(keeper, layer));
  }
  CHECK(bench.document().is_empty());
  CHECK_FALSE(bench.undo());
  check_refused(bench.insert(std::array{Vec2{}}), ErrorCode::usage, "this workbench keeps no document to edit");
}

TEST_CASE("variants are computed beside the document, each as by a workbench of its own") {
  JobControl job;
  ComputationSettings settings;
  settings[Parameter::lambda_limit] = 0.9;
  const auto other = std::make_shared<const SampleData>(SampleData{.positions = samples_of_ellipse(25)});
  const LayerIndex layer = builtins().find_layer("lambda-medial-axis");
  const auto alone = [&](const SampleData& data, const ComputationSettings& chosen) {
    Workbench bench(builtins());
    bench.choose(chosen);
    REQUIRE(bench.load(data));
    REQUIRE(bench.show({"lambda-medial-axis"}));
    REQUIRE(bench.run(job));
    return digest_in(bench, "lambda-medial-axis");
  };

  Workbench bench(builtins());
  const SampleData data{.positions = samples_of_ellipse(60)};
  REQUIRE(bench.load(data));
  REQUIRE(bench.compare_with(std::array{WorkbenchVariant{settings}, WorkbenchVariant{settings, other}}));
  CHECK(bench.variant_documents().at(0).is_empty());
  CHECK(bench.variant_documents().at(1).sample_count() == 25);
  bench.show({layer_in(kMainVariant, false, layer), layer_in(1, false, layer), layer_in(2, true, layer)});
  REQUIRE(bench.run(job));
  CHECK(digest_in(bench, "lambda-medial-axis") == alone(data, {}));
  CHECK(bench.mirror().digest({1, layer}).text() == alone(data, settings));
  CHECK(bench.mirror().digest({2, layer}).text() == alone(*other, settings));

  // Other variants take their place, with documents that begin anew.
  REQUIRE(bench.compare_with(std::array{WorkbenchVariant{{}, std::make_shared<const SampleData>(data)}}));
  bench.show({layer_in(1, true, layer)});
  REQUIRE(bench.run(job));
  CHECK(bench.mirror().digest({1, layer}).text() == alone(data, {}));
  const SampleData wrong{.balls = {Disk{{0.0, 0.0}, -1.0}}};
  CHECK_FALSE(bench.compare_with(std::array{WorkbenchVariant{{}, std::make_shared<const SampleData>(wrong)}}));
  CHECK(bench.variant_documents().size() == 1);
}

TEST_CASE("a one-shot workbench hands out the instances that another one keeps") {
  JobControl job;
  const SampleData data{.positions = samples_of_ellipse(200)};
  Workbench keeper(builtins());
  REQUIRE(keeper.load(data));
  REQUIRE(keeper.show({"medial-axis", "curve"}));
  REQUIRE(keeper.run(job));

  std::mutex mutex;
  std::vector<LayerDigest> taken(builtins().layers().size());
  Workbench bench(builtins(), {.take_instances = [&](const InstancePiece& piece) {
                    const std::lock_guard lock(mutex);
                    taken[piece.layer.layer] += digest_of(piece.kind, piece.values, !piece.scalars_are_names);
                  }});
  REQUIRE(bench.load(data));
  REQUIRE(bench.show({"medial-axis", "curve"}));
  REQUIRE(bench.run(job));
  for (const char* layer : {"medial-axis", "curve"})
    CHECK(taken[builtins().find_layer(layer)].text() == digest_in(keeper, layer));
  CHECK(bench.document().is_empty());
  check_refused(bench.insert(data.positions), ErrorCode::usage, "this workbench keeps no document to edit");
  check_refused(bench.digest("curve"), ErrorCode::usage, "this workbench keeps no instances");
}

TEST_CASE("a workbench that is moved goes on as it was") {
  JobControl job;
  Workbench first(builtins());
  REQUIRE(first.insert(samples_of_ellipse(30)));
  REQUIRE(first.show({"curve"}));
  REQUIRE(first.run(job));
  Workbench second = std::move(first);
  REQUIRE(second.insert(std::array{Vec2{3.0, 3.0}}));
  REQUIRE(second.run(job));
  CHECK(second.get<Delaunay>().site_rows() == 31);
  CHECK(second.undo());
  REQUIRE(second.run(job));
  CHECK(segments_in(second, "curve") == 30);
}

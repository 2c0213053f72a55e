// SPDX-License-Identifier: GPL-3.0-or-later
// A graph that keeps nothing for edits draws and counts what another one does.
#include <catch2/catch.hpp>
#include <mutex>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes {
namespace {

struct Layers {
  std::vector<LayerDigest> digest;
  std::vector<std::size_t> count;
};

std::shared_ptr<const DocumentDelta> document_of(const std::vector<Vec2>& points) {
  SampleData data;
  data.positions = points;
  return std::make_shared<const DocumentDelta>(*replace_all(Document(), data));
}

std::vector<LayerIndex> layers_of_samples() {
  std::vector<LayerIndex> out;
  for (const char* id : {"points", "delaunay", "voronoi", "curve", "medial-axis", "interior-voronoi-disks",
                         "label-conflicts", "feature-size", "lambda-medial-axis"})
    out.push_back(find_layer(id));
  return out;
}

void prepare(Graph& graph) {
  graph.set_want_statistics(true);
  graph.set_want_findings(true);
  graph.set_demand(layers_of_samples());
}

Layers kept(const std::vector<Vec2>& points, FramePatch& patch) {
  Graph graph{builtins()};
  prepare(graph);
  graph.post(document_of(points));
  JobControl job;
  REQUIRE(graph.run(patch, job));
  LayerMirror mirror;
  mirror.apply(patch);
  Layers out;
  for (const LayerIndex layer : layers_of_samples()) {
    out.digest.push_back(mirror.digest(layer));
    std::size_t& count = out.count.emplace_back(0);
    for (const PrimitiveKind kind : kAllPrimitiveKinds) count += mirror.count(layer, kind);
  }
  return out;
}

enum class Scalars : std::uint8_t { needed, not_needed, needed_and_left_out };

/// Computed `runs` times by one graph; of the last one. Digests have scalars if these are `needed`.
Layers poured(const std::vector<Vec2>& points, FramePatch& patch, int runs, Scalars scalars = Scalars::needed) {
  std::mutex mutex;
  std::vector<LayerDigest> digest(layer_descriptors().size());
  std::vector<std::size_t> count(layer_descriptors().size(), 0);
  Graph graph{builtins()};
  const auto take = [&](const InstancePiece& piece) {
    const std::lock_guard lock(mutex);
    digest[piece.layer.layer] +=
        digest_of(piece.kind, piece.values, scalars == Scalars::needed && !piece.scalars_are_names);
    count[piece.layer.layer] += piece.values.size() / stride_of(piece.kind);
  };
  graph.make_one_shot(take, scalars != Scalars::not_needed);
  prepare(graph);
  JobControl job;
  for (int run = 0; run < runs; ++run) {
    digest.assign(digest.size(), {});
    count.assign(count.size(), 0);
    graph.post(document_of(points));
    REQUIRE(graph.run(patch, job));
    CHECK(patch.layer_count == 0);
    graph.get_ready(job);
  }
  Layers out;
  for (const LayerIndex layer : layers_of_samples()) {
    out.digest.push_back(digest[layer]);
    out.count.push_back(count[layer]);
  }
  return out;
}

void compare(const std::vector<Vec2>& points) {
  FramePatch patch;
  FramePatch one_shot_patch;
  const Layers expected = kept(points, patch);
  for (const int runs : {1, 2}) {
    INFO(points.size() << " samples, run " << runs);
    const Layers found = poured(points, one_shot_patch, runs);
    CHECK(found.count == expected.count);
    CHECK(found.digest == expected.digest);
    REQUIRE(one_shot_patch.nodes.size() == patch.nodes.size());
    for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
      INFO(patch.nodes[i].structure);
      CHECK(one_shot_patch.nodes[i].state == patch.nodes[i].state);
      CHECK(one_shot_patch.nodes[i].stats.size() == patch.nodes[i].stats.size());
      REQUIRE(one_shot_patch.nodes[i].findings.size() == patch.nodes[i].findings.size());
      for (std::size_t k = 0; k < patch.nodes[i].findings.size(); ++k)
        CHECK(one_shot_patch.nodes[i].findings[k].count == patch.nodes[i].findings[k].count);
    }
    for (const LayerIndex layer : layers_of_samples())
      CHECK(one_shot_patch.reports[layer].lost == patch.reports[layer].lost);
  }
}

}  // namespace

TEST_CASE("a one-shot run draws and finds what a kept one does") {
  compare({});
  compare({{1.0, 2.0}});
  compare({{1.0, 2.0}, {3.0, -1.0}});
  compare({{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {5.0, 5.0}});
  compare(test::duplicate_heavy(300, 4));
  compare(test::benchmark_curve(5000, 2));
  compare(test::rough_curve(5000, 3));
  compare(test::uniform_square(5000, 5));
  // Several parts, stitched, and chunks of rows.
  compare(test::uniform_square(60000, 6));
}

TEST_CASE("a one-shot run without scalars draws the same without them, and does not look for those that take time") {
  for (const std::vector<Vec2>& points : {std::vector<Vec2>{{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}},
                                          test::benchmark_curve(5000, 2), test::uniform_square(5000, 5)}) {
    FramePatch patch;
    FramePatch patch_without;
    const Layers expected = poured(points, patch, 1, Scalars::needed_and_left_out);
    const Layers found = poured(points, patch_without, 1, Scalars::not_needed);
    CHECK(found.count == expected.count);
    CHECK(found.digest == expected.digest);
    for (const LayerIndex layer : layers_of_samples())
      CHECK(patch_without.reports[layer].lost == patch.reports[layer].lost);
  }
  // Of the curve, that is the confidence of each edge.
  for (const bool are_needed : {true, false}) {
    std::size_t count = 0;
    std::size_t with_scalar = 0;
    Graph graph{builtins()};
    graph.make_one_shot(
        [&](const InstancePiece& piece) {
          const std::size_t stride = stride_of(piece.kind);
          for (std::size_t at = 0; at < piece.values.size(); at += stride, ++count)
            with_scalar += piece.values[at + stride - 1] != 0.0 ? 1U : 0U;
        },
        are_needed);
    const std::vector<LayerIndex> layers{find_layer("curve")};
    graph.set_demand(layers);
    graph.post(document_of(test::benchmark_curve(1000, 2)));
    FramePatch patch;
    JobControl job;
    REQUIRE(graph.run(patch, job));
    CHECK(count == 1000);
    CHECK(with_scalar == (are_needed ? count : 0));
  }
}

TEST_CASE("edits are the same whether the graph was made ready for them or not") {
  const std::vector<Vec2> points = test::uniform_square(6000, 7);
  Document document;
  const auto first = document_of(points);
  document.apply(*first);
  Graph ready{builtins()};
  Graph surprised{builtins()};
  LayerMirror ready_mirror;
  LayerMirror surprised_mirror;
  FramePatch patch;
  JobControl job;
  const auto run = [&](Graph& graph, LayerMirror& mirror, const std::shared_ptr<const DocumentDelta>& delta) {
    graph.post(delta);
    REQUIRE(graph.run(patch, job));
    mirror.apply(patch);
  };
  for (Graph* graph : {&ready, &surprised}) graph->set_demand(layers_of_samples());
  run(ready, ready_mirror, first);
  ready.get_ready(job);
  run(surprised, surprised_mirror, first);
  for (std::size_t i = 0; i < 20; ++i) {
    const SampleSlot slot(i * 97);
    const Vec2 to = document.position(slot) + Vec2{0.3, -0.2};
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{document.id(slot), to}}));
    document.apply(*delta);
    run(ready, ready_mirror, delta);
    run(surprised, surprised_mirror, delta);
    for (const LayerIndex layer : layers_of_samples())
      CHECK(ready_mirror.digest(layer) == surprised_mirror.digest(layer));
  }
}

}  // namespace mes

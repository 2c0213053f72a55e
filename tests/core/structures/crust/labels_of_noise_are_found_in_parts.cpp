// SPDX-License-Identifier: GPL-3.0-or-later
// What labels of noise are made of is found in parts of the plane, side by side. Here it is found again as a whole, and
// with parts so small that little is decided within one.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/structures/crust/internal/label_spread.h"
#include "core/structures/crust/internal/open_strokes.h"
#include "core/structures/crust/internal/spanning_tree.h"
#include "core/structures/crust/labels.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/grid_draws.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct NoiseInput {
  std::string name;
  std::vector<Vec2> positions;
};

// Three arches with jitter, some of them open at their ends.
std::vector<Vec2> jittery_waves(double jitter, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (int wave = 0; wave < 3; ++wave)
    for (double t = 0.0; t < 12.0; t += rng.uniform(0.07, 0.11))
      out.push_back({100.0 * t + rng.uniform(-jitter, jitter),
                     100.0 * std::sin(t) + 150.0 * wave + rng.uniform(-jitter, jitter)});
  return out;
}

// Steps of 0.1, which no double is, so that edges are nearly alike and not quite.
std::vector<Vec2> rounded_lattice(int side, double turn) {
  std::vector<Vec2> out;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      out.push_back(
          {0.1 * i * std::cos(turn) - 0.1 * j * std::sin(turn), 0.1 * i * std::sin(turn) + 0.1 * j * std::cos(turn)});
  return out;
}

// Nearly all in one cell of any grid.
std::vector<Vec2> cluster_and_far_point(std::size_t n) {
  std::vector<Vec2> out = uniform_square(n, 12);
  for (Vec2& p : out) p = 1e-6 * p;
  out.push_back({1e6, 1e5});
  return out;
}

std::vector<NoiseInput> noise_inputs() {
  std::vector<NoiseInput> out = {{"square", uniform_square(700, 3)},
                                 {"noisy curve", noisy_curve(500)},
                                 {"rough curve", rough_curve(500)},
                                 {"smooth curve", benchmark_curve(400)},
                                 {"duplicates", duplicate_heavy(800)},
                                 {"lattice", grid_draws(500, 24, 5)},
                                 {"coarse lattice", grid_draws(300, 9, 6)},
                                 {"cluster", cluster_and_far_point(300)},
                                 {"rounded lattice", rounded_lattice(18, 0.0)},
                                 {"turned lattice", rounded_lattice(18, 0.3)}};
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double jitter = 0.6 * static_cast<double>(seed - 1);
    out.push_back({"waves", jittery_waves(jitter, seed)});
  }
  for (DegenerateInput& input : degenerate_inputs()) out.push_back({input.name, std::move(input.positions)});
  return out;
}

std::vector<CertaintyOrder::Rank> all_ranks(const Delaunay& delaunay, const CertaintyOrder& order) {
  std::vector<CertaintyOrder::Rank> out;
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive()) out.push_back(order.rank_of(edge));
  return out;
}

// Kruskal's algorithm; sets are relabelled one by one.
Table<EdgeSlot, std::uint8_t> plain_tree(const Delaunay& delaunay, const CertaintyOrder& order) {
  std::vector<CertaintyOrder::Rank> ranks = all_ranks(delaunay, order);
  std::ranges::sort(ranks, [&](const auto& a, const auto& b) { return order.is_surer(b, a); });
  Table<SiteSlot, SiteSlot> set;
  for (const SiteSlot site : delaunay.site_slots()) set.push_back(site);
  Table<EdgeSlot, std::uint8_t> out(delaunay.edge_rows(), 0);
  for (const auto& rank : ranks) {
    const SiteSlot kept = set[delaunay.edge(rank.edge).v[0]];
    const SiteSlot gone = set[delaunay.edge(rank.edge).v[1]];
    if (kept == gone) continue;
    out[rank.edge] = 1;
    std::ranges::replace(set, gone, kept);
  }
  return out;
}

// Inside faces and conflicts, by where they are.
std::pair<std::vector<std::array<double, 2>>, std::vector<std::array<double, 4>>> labels_of(const Graph& graph) {
  const auto& delaunay = graph.structures().get<Delaunay>();
  const auto& labels = graph.structures().get<Labels>();
  std::vector<std::array<double, 2>> inside;
  for (const FaceSlot face : delaunay.face_slots())
    if (delaunay.is_finite_face(face) && labels.is_inside(face))
      inside.push_back({delaunay.circumcenter(face).x, delaunay.circumcenter(face).y});
  std::vector<std::array<double, 4>> conflicts;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || !labels.is_conflict(edge)) continue;
    Vec2 a = delaunay.site_position(delaunay.edge(edge).v[0]);
    Vec2 b = delaunay.site_position(delaunay.edge(edge).v[1]);
    if (lexicographically_less(b, a)) std::swap(a, b);
    conflicts.push_back({a.x, a.y, b.x, b.y});
  }
  std::ranges::sort(inside);
  std::ranges::sort(conflicts);
  CHECK(inside.size() > 1000);
  CHECK(conflicts.size() > 1000);
  return {inside, conflicts};
}

}  // namespace

TEST_CASE("edges are sorted as by exact comparisons alone") {
  for (const NoiseInput& input : noise_inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    if (delaunay.dimension() < 2) continue;
    const CertaintyOrder order(delaunay, bench.get<OneStepCrust>());
    std::vector<CertaintyOrder::Rank> ranks = all_ranks(delaunay, order);
    JobControl job;
    order.sort(ranks, job);
    CHECK(ranks.size() == all_ranks(delaunay, order).size());
    CHECK(std::ranges::is_sorted(ranks, [&](const auto& a, const auto& b) { return order.is_surer(b, a); }));
    CHECK(std::ranges::adjacent_find(ranks, {}, &CertaintyOrder::Rank::edge) == ranks.end());
  }
}

TEST_CASE("the spanning tree is the same whatever the blocks in which it is found") {
  JobControl job;
  std::size_t edges = 0;
  for (const NoiseInput& input : noise_inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    if (delaunay.dimension() < 2) continue;
    CertaintyOrder order(delaunay, bench.get<OneStepCrust>());
    const Table<EdgeSlot, std::uint8_t> plain = plain_tree(delaunay, order);
    order.find_keys();
    for (const std::size_t sites_per_block : {1U, 3U, 20U, 100U, 8192U}) {
      INFO(sites_per_block << " sites a block");
      CHECK(spanning_tree(delaunay, order, job, sites_per_block) == plain);
    }
    edges += static_cast<std::size_t>(std::ranges::count(plain, 1));
  }
  CHECK(edges > 5000);
}

TEST_CASE("open strokes are the same where updates are not prepared for") {
  JobControl job;
  std::size_t strokes = 0;
  std::size_t without = 0;
  for (const NoiseInput& input : noise_inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& crust = bench.get<OneStepCrust>();
    if (delaunay.dimension() < 2 || crust.odd_count() == 0) continue;
    CertaintyOrder order(delaunay, crust);
    OpenStrokes ready(delaunay, crust, order);
    ready.rebuild(job);
    CHECK(ready.is_ready_to_update());
    order.find_keys();
    OpenStrokes quick(delaunay, crust, order);
    quick.rebuild_for_labels_alone(spanning_tree(delaunay, order, job, 50), job);
    CHECK_FALSE(quick.is_ready_to_update());
    CHECK(quick.count() == ready.count());
    for (const EdgeSlot edge : delaunay.edge_slots())
      if (quick.has_edge(edge) != ready.has_edge(edge)) FAIL("an edge is on a stroke for one and not for the other");
    for (const SiteSlot site : delaunay.site_slots())
      if (quick.ends_at(site) != ready.ends_at(site)) FAIL("a stroke ends here for one and not for the other");
    strokes += ready.count();
    without += ready.count() == 0 ? 1U : 0U;
  }
  CHECK(strokes > 10);
  CHECK(without > 3);
}

TEST_CASE("labels are the same whatever the parts in which they are handed on") {
  JobControl job;
  for (const NoiseInput& input : noise_inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& crust = bench.get<OneStepCrust>();
    const auto& labels = bench.get<Labels>();
    if (delaunay.dimension() < 2) continue;
    const auto is_border = [&](FaceSlot face, int i) {
      const EdgeSlot edge = delaunay.face(face).e[i];
      return edge != kNoSlot && crust.is_crust(edge) != labels.is_conflict(edge);
    };
    const auto everywhere = [](FaceSlot, int) { return true; };
    // Along the edges of faces that a search from the first row on finds first, which hang together, too.
    Table<FaceSlot, std::uint8_t> seen(delaunay.face_rows(), 0);
    Table<FaceSlot, std::uint8_t> ways(delaunay.face_rows(), 0);
    std::vector<FaceSlot> queue;
    for (const FaceSlot face : delaunay.face_slots()) {
      if (!delaunay.face(face).is_alive()) continue;
      queue.push_back(face);
      seen[face] = 1;
      break;
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const FaceRow& row = delaunay.face(queue[next]);
      for (unsigned i = 0; i < 3; ++i) {
        if (seen[row.n[i]] != 0) continue;
        seen[row.n[i]] = 1;
        ways[queue[next]] = static_cast<std::uint8_t>(ways[queue[next]] | (1U << i));
        const FaceRow& other = delaunay.face(row.n[i]);
        for (unsigned j = 0; j < 3; ++j)
          if (other.n[j] == queue[next] && other.e[j] == row.e[i])
            ways[row.n[i]] = static_cast<std::uint8_t>(ways[row.n[i]] | (1U << j));
        queue.push_back(row.n[i]);
      }
    }
    const auto along_a_tree = [&](FaceSlot face, int i) {
      return ((static_cast<unsigned>(ways[face]) >> static_cast<unsigned>(i)) & 1U) != 0;
    };
    for (const std::size_t parts : {1U, 2U, 5U, 37U}) {
      INFO(parts << " parts");
      Table<FaceSlot, std::uint8_t> all;
      LabelSpread(delaunay, everywhere, is_border).run(all, parts, job);
      Table<FaceSlot, std::uint8_t> few;
      LabelSpread(delaunay, along_a_tree, is_border).run(few, parts, job);
      for (const FaceSlot face : delaunay.face_slots()) {
        if (!delaunay.face(face).is_alive()) continue;
        if ((all[face] != 0) != labels.is_inside(face)) FAIL("a label differs where it is handed on everywhere");
        if ((few[face] != 0) != labels.is_inside(face)) FAIL("a label differs where it is handed on along a tree");
      }
    }
  }
}

TEST_CASE("rows that are not alive have no label, whatever part they are in") {
  // From the last rows to the first, so that whole parts hold nothing.
  ComparedBench bench(uniform_square(700, 3));
  bench.show({"interior-voronoi-disks"});
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  const auto& labels = bench.get<Labels>();
  const auto is_border = [&](FaceSlot face, int i) {
    const EdgeSlot edge = delaunay.face(face).e[i];
    return edge != kNoSlot && crust.is_crust(edge) != labels.is_conflict(edge);
  };
  const auto everywhere = [](FaceSlot, int) { return true; };
  std::size_t dead = 0;
  for (int round = 0; round < 6; ++round) {
    std::vector<SampleId> ids = bench.ids();
    ids.erase(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2));
    for (const SampleId id : ids) bench.remove({id});
    for (const std::size_t parts : {2U, 5U, 37U, 200U}) {
      Table<FaceSlot, std::uint8_t> inside;
      JobControl job;
      LabelSpread(delaunay, everywhere, is_border).run(inside, parts, job);
      for (const FaceSlot face : delaunay.face_slots()) {
        const bool is_alive = delaunay.face(face).is_alive();
        dead += is_alive ? 0U : 1U;
        if ((inside[face] != 0) != (is_alive && labels.is_inside(face))) FAIL("a label differs");
      }
    }
  }
  CHECK(dead > 1000);
}

TEST_CASE("noise that was labelled for the picture alone is followed as if it had been made ready") {
  Rng rng(21);
  // So many that labels are made first and what updates need later; with open strokes beside them.
  std::vector<Vec2> positions = uniform_square(11000, 4);
  Box2 square;
  for (const Vec2 p : positions) square.add(p);
  const double size = square.width();
  for (int spiral = 0; spiral < 20; ++spiral)
    for (double t = 0.0; t < 12.0; t += 0.1)
      positions.push_back({square.high.x + size * (0.3 + 0.004 * t * std::cos(t)),
                           square.low.y + size * (0.05 * spiral + 0.0015 * t * std::sin(t))});
  const auto make = [&positions](Graph& graph, Document& document) {
    graph.set_demand(std::vector{find_layer("interior-voronoi-disks"), find_layer("label-conflicts")});
    SampleData data;
    data.positions = positions;
    const auto delta = std::make_shared<const DocumentDelta>(*replace_all(document, data));
    document.apply(*delta);
    graph.post(delta);
    FramePatch patch;
    JobControl job;
    REQUIRE(graph.run(patch, job));
  };
  Graph early{builtins()};
  Graph ready{builtins()};
  Graph stopped{builtins()};
  Document document;
  for (Graph* graph : {&early, &ready, &stopped}) {
    document = Document();
    make(*graph, document);
  }
  const auto& crust = early.structures().get<OneStepCrust>();
  CHECK(crust.odd_count() > 4096);
  for (int step = 0; step < 4; ++step) {
    INFO("step " << step);
    JobControl job;
    ready.get_ready(job);
    // Interrupted anywhere, it is as if it had not been begun.
    JobControl interrupted;
    interrupted.stop_at_look(1 + 3 * step);
    stopped.get_ready(interrupted);
    if (step > 0) stopped.get_ready(job);
    const SampleSlot slot(rng.below(positions.size()));
    const Vec2 to = document.position(slot) + Vec2{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{document.id(slot), to}}));
    document.apply(*delta);
    for (Graph* graph : {&early, &ready, &stopped}) {
      graph->post(delta);
      FramePatch patch;
      REQUIRE(graph->run(patch, job));
    }
    REQUIRE(broken_row(early) == "");
    REQUIRE(broken_row(ready) == "");
    REQUIRE(broken_row(stopped) == "");
    Graph fresh{builtins()};
    fresh.set_demand(std::vector{find_layer("interior-voronoi-disks"), find_layer("label-conflicts")});
    SampleData data;
    for (const SampleSlot one : slots_below<SampleSlot>(positions.size()))
      data.positions.push_back(document.position(one));
    fresh.post(std::make_shared<const DocumentDelta>(*replace_all(Document(), data)));
    FramePatch patch;
    REQUIRE(fresh.run(patch, job));
    const auto expected = labels_of(fresh);
    REQUIRE(labels_of(early) == expected);
    REQUIRE(labels_of(ready) == expected);
    REQUIRE(labels_of(stopped) == expected);
  }
}

TEST_CASE("an edit of noise names each row with a new label once, and no row far away without one") {
  Rng rng(31);
  Graph graph{builtins()};
  graph.set_demand(std::vector{find_layer("interior-voronoi-disks"), find_layer("label-conflicts")});
  Document document;
  FramePatch patch;
  JobControl job;
  const auto run = [&](const Expected<DocumentDelta>& delta) {
    REQUIRE(delta);
    const auto shared = std::make_shared<const DocumentDelta>(*delta);
    document.apply(*shared);
    graph.post(shared);
    REQUIRE(graph.run(patch, job));
    graph.get_ready(job);
  };
  SampleData data;
  data.positions = uniform_square(3000, 7);
  run(replace_all(document, data));
  const auto& delaunay = graph.structures().get<Delaunay>();
  const auto& labels = graph.structures().get<Labels>();
  std::vector<SampleId> ids;
  for (const SampleSlot slot : slots_below<SampleSlot>(data.positions.size())) ids.push_back(document.id(slot));

  // By row: alive, and its label or conflict.
  const auto faces_now = [&] {
    std::vector<std::pair<bool, bool>> out;
    for (const FaceSlot face : delaunay.face_slots())
      out.emplace_back(delaunay.face(face).is_alive(), labels.is_inside(face));
    return out;
  };
  const auto edges_now = [&] {
    std::vector<std::pair<bool, bool>> out;
    for (const EdgeSlot edge : delaunay.edge_slots())
      out.emplace_back(delaunay.edge(edge).is_alive(), labels.is_conflict(edge));
    return out;
  };
  const auto rows_of = [](const auto& changes) {
    std::vector<RowNumber> rows;
    for (const auto& list : {changes.touched, changes.removed})
      for (const auto row : list) rows.push_back(row.index());
    std::ranges::sort(rows);
    REQUIRE(std::ranges::adjacent_find(rows) == rows.end());
    return rows;
  };
  std::size_t most_turned = 0;
  for (int step = 0; step < 200; ++step) {
    INFO("step " << step);
    const auto faces_before = faces_now();
    const auto edges_before = edges_now();
    const std::size_t i = rng.below(ids.size());
    const Vec2 place{rng.uniform(0.0, 400.0), rng.uniform(0.0, 400.0)};
    if (step % 3 == 0) {
      run(remove_samples(document, std::vector{ids[i]}));
      ids[i] = ids.back();
      ids.pop_back();
    } else if (step % 3 == 1) {
      ids.push_back(document.next_id());
      run(insert_samples(document, std::vector{place}));
    } else {
      run(move_samples(document, std::vector{std::pair{ids[i], place}}));
    }

    const auto faces_after = faces_now();
    const std::vector<RowNumber> faces = rows_of(labels.face_changes());
    const std::vector<RowNumber> new_faces = rows_of(delaunay.face_changes());
    REQUIRE(std::ranges::includes(faces, new_faces));
    const auto is_turned = [&](FaceSlot face) {
      return face.index() < faces_before.size() && faces_before[face.index()] != faces_after[face.index()];
    };
    std::size_t turned = 0;
    for (const FaceSlot face : delaunay.face_slots()) {
      if (std::ranges::binary_search(new_faces, face.index())) continue;
      REQUIRE(std::ranges::binary_search(faces, face.index()) == is_turned(face));
      turned += is_turned(face) ? 1U : 0U;
    }
    most_turned = std::max(most_turned, turned);

    const auto edges_after = edges_now();
    const std::vector<RowNumber> edges = rows_of(labels.edge_changes());
    const std::vector<RowNumber> new_edges = rows_of(delaunay.edge_changes());
    REQUIRE(std::ranges::includes(edges, new_edges));
    std::size_t conflicts = 0;
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      conflicts += edges_after[edge.index()].second ? 1U : 0U;
      if (std::ranges::binary_search(new_edges, edge.index())) continue;
      const EdgeRow& row = delaunay.edge(edge);
      const bool is_touched = row.is_alive() && (is_turned(row.f[0]) || is_turned(row.f[1]));
      const bool differs = edges_before[edge.index()] != edges_after[edge.index()];
      REQUIRE(std::ranges::binary_search(edges, edge.index()) == (is_touched || differs));
    }
    REQUIRE(labels.conflict_count() == conflicts);
  }
  CHECK(most_turned > 256);
}

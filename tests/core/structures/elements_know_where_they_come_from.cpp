// SPDX-License-Identifier: GPL-3.0-or-later
// Pointing at things: what is found, what it is made of, and that no dead row is ever met.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/ball_union.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

const ProvenanceLine* line_with(const Provenance& answer, ProvenanceRole role, std::string_view text) {
  for (const ProvenanceLine& line : answer.lines)
    if (line.role == role && line.text.find(text) != std::string::npos) return &line;
  return nullptr;
}
std::size_t shapes_named(const Provenance& answer, ProvenanceRole role, std::string_view text) {
  const ProvenanceLine* line = line_with(answer, role, text);
  return line == nullptr ? 0 : line->shapes.size();
}

}  // namespace

TEST_CASE("an inner Voronoi vertex comes from its samples and makes axis and union") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& axis = bench.get<MedialAxis>();
  std::size_t seen = 0;
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(face) || !bench.get<InnerBalls>().is_ball(face) || axis.node_degree(face) != 2)
      continue;
    ++seen;
    const Provenance answer = bench.ask(delaunay.circumcenter(face), 1e-9, {"interior-voronoi-vertices"});
    REQUIRE_FALSE(answer.lines.empty());
    CHECK(answer.layer == find_layer("interior-voronoi-vertices"));
    CHECK(answer.lines.front().role == ProvenanceRole::itself);
    CHECK(answer.lines.front().text.starts_with("Inner Voronoi ball at ("));
    CHECK(shapes_named(answer, ProvenanceRole::origin, "3 samples on its circle") == 3);
    CHECK(shapes_named(answer, ProvenanceRole::origin, "1 Delaunay triangle") == 1);
    CHECK(shapes_named(answer, ProvenanceRole::product, "medial axis edges end here") == 2);
    CHECK(shapes_named(answer, ProvenanceRole::product, "of its power cell") >= 3);
    CHECK(shapes_named(answer, ProvenanceRole::product, "on the boundary of the union") >= 1);
  }
  CHECK(seen > 40);
}

TEST_CASE("an axis edge comes from two samples and ends in two balls") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  const auto& delaunay = bench.get<Delaunay>();
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive() || !bench.get<MedialAxis>().is_axis_edge(edge)) continue;
    const Vec2 middle = 0.5 * (delaunay.circumcenter(row.f[0]) + delaunay.circumcenter(row.f[1]));
    const Provenance answer = bench.ask(middle, 1e-9, {"medial-axis"});
    CHECK(answer.lines.front().text.starts_with("Medial axis edge"));
    CHECK(shapes_named(answer, ProvenanceRole::origin, "2 samples") == 2);
    CHECK(shapes_named(answer, ProvenanceRole::product, "Voronoi balls at its ends") == 2);
  }
}

TEST_CASE("a v-point names the balls whose circles cross there, and a circle all samples on it") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  std::size_t seen = 0;
  for (const VPoint& v : bench.get<AUnion>().tables().v_points) {
    if (!v.is_alive()) continue;
    ++seen;
    const Provenance answer = bench.ask(v.position, 1e-9, {"a-v-points"});
    CHECK(answer.lines.front().text.ends_with("a sample"));
    CHECK(shapes_named(answer, ProvenanceRole::origin, "balls whose circles cross here") >= 2);
  }
  CHECK(seen > 40);

  std::vector<Vec2> circle;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      if (x * x + y * y == 25) circle.push_back({static_cast<double>(x), static_cast<double>(y)});
  bench.replace(circle);
  const Provenance answer = bench.ask({0, 0}, 1e-9, {"interior-voronoi-vertices"});
  CHECK(shapes_named(answer, ProvenanceRole::origin, "12 samples on its circle") == 12);
  CHECK(shapes_named(answer, ProvenanceRole::origin, "triangles on one circle") == 10);
}

TEST_CASE("points win over lines and lines over areas; the upper layer over the lower") {
  TestBench bench(std::vector<Vec2>{{0, 0}, {4, 0}, {0, 3}});
  CHECK(bench.ask({0.1, 0}, 0.2, {"points"}).lines.front().text.starts_with("Sample at (0, 0)"));
  CHECK(bench.ask({2, 0.1}, 0.2, {"points", "delaunay"}).layer == find_layer("delaunay"));
  CHECK(bench.ask({2, 1}, 0.05, {"points", "delaunay"}).lines.empty());
  CHECK(bench.ask({2, 1}, 0.05, {"delaunay", "interior-voronoi-disks"}).layer ==
        find_layer("interior-voronoi-disks"));
  CHECK(bench.ask({2, 1}, 0.05, {}).lines.empty());
}

TEST_CASE("alpha complexes say from which radius on their elements are there, and what ends their classes") {
  TestBench bench(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2.5}});
  ComputationSettings settings;
  settings[Parameter::alpha_radius] = 1.375;
  bench.choose(settings);
  bench.show({"alpha-disks", "alpha-edges", "alpha-triangles", "alpha-boundary", "alpha-components", "alpha-holes"});
  const Provenance edge = bench.ask({1, 0}, 1e-9, {"alpha-edges"});
  CHECK(shapes_named(edge, ProvenanceRole::product, "in the alpha complex from radius 1 on: there") == 1);
  const Provenance disk = bench.ask({-0.5, -0.5}, 1e-9, {"alpha-disks"});
  CHECK(shapes_named(disk, ProvenanceRole::product, "its alpha disk has radius 1.375") == 1);
  const Provenance arc = bench.ask({-1.375, 0}, 1e-9, {"alpha-boundary"});
  REQUIRE_FALSE(arc.lines.empty());
  CHECK(arc.lines.front().text == "Arc on the boundary of the union of the alpha disks, radius 1.375");
  CHECK(shapes_named(arc, ProvenanceRole::origin, "the sample that it goes around") == 1);
  const Provenance component = bench.ask({0, 0}, 1e-9, {"alpha-components"});
  REQUIRE_FALSE(component.lines.empty());
  CHECK(component.lines.front().text == "Component of the alpha complex, born at radius 0, stays");
  const auto circle = bench.instances("alpha-holes", PrimitiveKind::circle);
  REQUIRE(circle.size() == stride_of(PrimitiveKind::circle));
  const Provenance hole = bench.ask({circle[0] + circle[2], circle[1]}, 1e-9, {"alpha-holes"});
  REQUIRE_FALSE(hole.lines.empty());
  CHECK(hole.lines.front().text.starts_with("Hole of the alpha complex, closed at radius 1.25, filled at 1."));
  CHECK(shapes_named(hole, ProvenanceRole::origin, "the edge that closes it") == 1);
  CHECK(shapes_named(hole, ProvenanceRole::product, "the triangle that fills it") == 1);
}

TEST_CASE("balls that grow additively say how large they were, and when what joins them came") {
  TestBench bench;
  SampleData data;
  data.balls = {{{0, 0}, 1.0}, {{4, 0}, 1.0}, {{4, 4}, 1.0}, {{0, 4.5}, 1.0}};
  bench.load(data);
  ComputationSettings settings;
  settings[Parameter::alpha_radius] = 2.125;
  bench.choose(settings);
  bench.show({"b-alpha-disks", "b-alpha-edges", "b-alpha-triangles", "b-alpha-boundary", "b-alpha-components",
              "b-alpha-holes"});
  const Provenance disk = bench.ask({-1, -1}, 1e-9, {"b-alpha-disks"});
  REQUIRE_FALSE(disk.lines.empty());
  CHECK(disk.lines.front().text == "Ball of radius 1, grown additively to 2.34854");
  CHECK(shapes_named(disk, ProvenanceRole::origin, "the ball as it is") == 1);
  const Provenance edge = bench.ask({2, 0}, 1e-9, {"b-alpha-edges"});
  REQUIRE_FALSE(edge.lines.empty());
  CHECK(edge.lines.front().text == "Edge of the dual complex of the grown balls, there from growth 1.73205 on");
  CHECK(shapes_named(edge, ProvenanceRole::origin, "2 balls that meet") == 2);
  const Provenance component = bench.ask({0, 0}, 1e-9, {"b-alpha-components"});
  REQUIRE_FALSE(component.lines.empty());
  CHECK(component.lines.front().text.starts_with("Component of the grown balls, born before balls grow, stays"));
  const auto circle = bench.instances("b-alpha-holes", PrimitiveKind::circle);
  REQUIRE(circle.size() == stride_of(PrimitiveKind::circle));
  const Provenance hole = bench.ask({circle[0] + circle[2], circle[1]}, 1e-9, {"b-alpha-holes"});
  REQUIRE_FALSE(hole.lines.empty());
  CHECK(hole.lines.front().text.starts_with(
      "Hole between the grown balls, closed at growth 2.01556, filled at growth"));
}

TEST_CASE("a ball along the scale axis says how large it was in the grown union") {
  TestBench bench(ellipse(2.0, 1.0, 60, {.offset = 0.3}).data.positions);
  ComputationSettings settings;
  settings[Parameter::scale_axis_factor] = 1.5;
  bench.choose(settings);
  bench.show({"scale-axis-circles", "scale-axis"});
  const auto circles = bench.instances("scale-axis-circles", PrimitiveKind::circle);
  REQUIRE(circles.size() >= stride_of(PrimitiveKind::circle));
  const Provenance circle = bench.ask({circles[0] + circles[2], circles[1]}, 1e-9, {"scale-axis-circles"});
  REQUIRE_FALSE(circle.lines.empty());
  CHECK(circle.lines.front().text.starts_with("Ball about a point of the scale axis, radius "));
  CHECK(shapes_named(circle, ProvenanceRole::origin, "in the grown union, 1.5 times as large") == 1);
  const Provenance piece = bench.ask({0, 0}, 0.01, {"scale-axis"});
  CHECK(shapes_named(piece, ProvenanceRole::product, "radii divided by 1.5 again") == 2);
}

TEST_CASE("whatever is pointed at, after whatever edits, has an answer without dead rows") {
  Rng rng(11);
  for (const bool on_lattice : {false, true}) {
    const auto some_point = [&]() -> Vec2 {
      if (on_lattice) return {static_cast<double>(rng.below(6)), static_cast<double>(rng.below(6))};
      return {6.0 * rng.uniform(), 6.0 * rng.uniform()};
    };
    TestBench bench;
    SampleData data;
    for (int i = 0; i < 30; ++i) data.positions.push_back(some_point());
    for (int i = 0; i < 4; ++i) data.balls.push_back({some_point(), 0.5 + rng.uniform()});
    bench.load(data);
    for (int round = 0; round < 12; ++round) {
      for (LayerIndex layer = 0; layer < layer_descriptors().size(); ++layer) {
        const std::string_view id = layer_descriptors()[layer].id;
        INFO(id << " in round " << round);
        for (const PrimitiveKind kind : layer_descriptors()[layer].kinds) {
          const auto instances = bench.instances(id, kind);
          const std::size_t count = instances.size() / stride_of(kind);
          for (std::size_t i = 0; i < count; i += 1 + count / 4) {
            const double* values = instances.data() + i * stride_of(kind);
            const bool is_arc = kind == PrimitiveKind::arc;
            const Vec2 at = is_arc ? Vec2{values[3], values[4]} : Vec2{values[0], values[1]};
            const double radius = kind == PrimitiveKind::circle ? values[2] : 0.0;
            const Provenance answer = bench.ask({at.x + radius, at.y}, 1e-6 * (1.0 + radius), {id});
            REQUIRE_FALSE(answer.lines.empty());
            REQUIRE_FALSE(answer.lines.front().shapes.empty());
            for (const ProvenanceLine& line : answer.lines) REQUIRE_FALSE(line.text.empty());
          }
        }
      }
      const auto ids = bench.ids();
      switch (rng.below(3)) {
        case 0: bench.insert({some_point()}); break;
        case 1: bench.remove({ids[rng.below(ids.size())]}); break;
        default: bench.move(ids[rng.below(ids.size())], some_point()); break;
      }
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The union of balls against what is known of it: unions with a formula, the theorem of the demo paper, fixtures in
// which the theorem fails, and the number types against each other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "core/base/geometry/arc.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "core/engine/theorem_light.h"
#include "core/io/format.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/precision_difference.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// A graph with the layers given, in a number type.
class Analysis {
 public:
  Analysis(const SampleData& data, Precision precision, bool use_shortcut,
           std::initializer_list<std::string_view> layers = {"medial-axis", "a-ball-medial-axis",
                                                             "b-ball-medial-axis"}) {
    std::vector<LayerIndex> demand;
    for (const std::string_view layer : layers) demand.push_back(find_layer(layer));
    graph_.set_demand(demand);
    graph_.set_want_statistics(true);
    graph_.set_want_findings(true);
    const auto delta = replace_all(document_, data);
    REQUIRE(delta.has_value());
    document_.apply(*delta);
    graph_.post(std::make_shared<const DocumentDelta>(*delta));
    choose(precision, use_shortcut);
  }
  void choose(Precision precision, bool use_shortcut) {
    ComputationSettings settings;
    settings.precision = precision;
    settings[Parameter::union_shortcut] = use_shortcut ? 1.0 : 0.0;
    graph_.post_settings(settings);
    JobControl job;
    REQUIRE(graph_.run(patch_, job));
  }
  std::int64_t count(std::string_view structure, std::string_view key) const {
    return std::get<std::int64_t>(stat(structure, key));
  }
  double measure(std::string_view structure, std::string_view key) const {
    return std::get<double>(stat(structure, key));
  }
  const NodeReport& node(std::string_view structure) const {
    for (const NodeReport& node : patch_.nodes)
      if (node.structure == structure) return node;
    FAIL("no structure " << structure);
    return patch_.nodes.front();
  }
  TheoremLight light() const { return light_of(patch_.nodes); }
  template <class T>
  const T& get() const {
    return graph_.structures().get<T>();
  }

 private:
  const StatValue& stat(std::string_view structure, std::string_view key) const {
    const NodeReport& report = node(structure);
    INFO(structure << ": " << report.reason);
    REQUIRE(report.state == NodeState::up_to_date);
    for (const Stat& entry : report.stats)
      if (entry.key == key) return entry.value;
    FAIL("no counter " << key << " of " << structure);
    return report.stats.front().value;
  }
  Document document_;
  Graph graph_{builtins()};
  FramePatch patch_;
};

SampleData balls_of(std::vector<Disk> disks) {
  SampleData data;
  data.balls = std::move(disks);
  return data;
}
SampleData points_of(const std::vector<std::pair<int, int>>& points) {
  SampleData data;
  for (const auto& [x, y] : points) data.positions.push_back({static_cast<double>(x), static_cast<double>(y)});
  return data;
}

/// The samples that are v-points; kNoSlot stands for all others.
std::set<SiteSlot> v_points_of(const BallUnion& balls) {
  std::set<SiteSlot> out;
  for (const VPoint& v : balls.tables().v_points)
    if (v.is_alive()) out.insert(v.site);
  return out;
}
/// A ball by its samples: the same whatever number type made its centre.
std::set<std::pair<AxisNodeSlot, AxisNodeSlot>> axis_between_balls(const BallUnion& balls) {
  std::set<std::pair<AxisNodeSlot, AxisNodeSlot>> out;
  for (const AxisPiece& piece : balls.tables().axis) {
    if (!piece.is_alive() || piece.is_zero != 0) continue;
    out.insert(std::minmax(piece.node[0], piece.node[1]));
  }
  return out;
}

struct ExpectedUnion {
  std::int64_t components, cycles, edges;
  double length, area;
};
void check_union(const std::string& name, const std::vector<Disk>& disks, const ExpectedUnion& expected) {
  for (const Precision precision : {Precision::fast, Precision::exact, Precision::exact_roots}) {
    INFO(name << " in " << id_of(precision));
    const Analysis analysis(balls_of(disks), precision, true);
    CHECK(analysis.count("b-union", "components") == expected.components);
    CHECK(analysis.count("b-union", "cycles") == expected.cycles);
    CHECK(analysis.count("b-union", "edges") == expected.edges);
    CHECK(analysis.count("b-union", "chi") == analysis.count("b-union", "chi_dual"));
    CHECK(analysis.measure("b-union", "length") == Approx(expected.length).margin(1e-12));
    CHECK(analysis.measure("b-union", "area") == Approx(expected.area).epsilon(1e-12));
  }
}

constexpr double kPi = std::numbers::pi;

/// Area of two equal disks of radius r at distance d.
double two_disks(double r, double d) {
  return 2.0 * kPi * r * r - (2.0 * r * r * std::acos(d / (2.0 * r)) - 0.5 * d * std::sqrt(4.0 * r * r - d * d));
}

}  // namespace

TEST_CASE("unions whose axis is known have it in every number type") {
  check_union("one disk", {{{1, 2}, 3}}, {1, 0, 0, 0.0, 9 * kPi});
  check_union("two crossing disks", {{{0, 0}, 1}, {{1.5, 0}, 1}}, {1, 0, 1, 1.5, two_disks(1, 1.5)});
  check_union("two tangent disks", {{{0, 0}, 1}, {{3, 0}, 2}}, {1, 0, 1, 3.0, 5 * kPi});
  check_union("two disks apart", {{{0, 0}, 1}, {{4, 0}, 1}}, {2, 0, 0, 0.0, 2 * kPi});
  check_union("a disk in a disk", {{{0, 0}, 3}, {{1, 0}, 1}}, {1, 0, 0, 0.0, 9 * kPi});
  check_union("a disk that touches from inside", {{{0, 0}, 3}, {{2, 0}, 1}}, {1, 0, 0, 0.0, 9 * kPi});
  check_union("concentric disks", {{{0, 0}, 3}, {{0, 0}, 1}, {{0, 0}, 3}}, {1, 0, 0, 0.0, 9 * kPi});
  check_union("three in a row", {{{0, 0}, 1}, {{1.5, 0}, 1}, {{3, 0}, 1}},
              {1, 0, 2, 3.0, 2 * two_disks(1, 1.5) - kPi});
  // Disks that cross pairwise and leave a gap: the axis is the triangle.
  const double side = std::sqrt(1.7 * 1.7 + 1.0);
  const auto lens = [](double radius, double d) { return 2.0 * kPi * radius * radius - two_disks(radius, d); };
  check_union("three disks around a gap", {{{0, 0}, 1.1}, {{2, 0}, 1.1}, {{1, 1.7}, 1.1}},
              {1, 1, 3, 2.0 + 2.0 * side, 3 * kPi * 1.1 * 1.1 - lens(1.1, 2.0) - 2.0 * lens(1.1, side)});
}

TEST_CASE("three disks that cover their middle have a tree of three segments that meet in equal distance") {
  const double side = 2.0;
  const double height = std::sqrt(3.0);
  const std::vector<Disk> disks{{{0, 0}, 1.5}, {{side, 0}, 1.5}, {{1, height}, 1.5}};
  for (const Precision precision : {Precision::fast, Precision::exact, Precision::exact_roots}) {
    const Analysis analysis(balls_of(disks), precision, true);
    CHECK(analysis.count("b-union", "edges") == 3);
    CHECK(analysis.count("b-union", "cycles") == 0);
    CHECK(analysis.count("b-union", "branch_points") == 1);
    CHECK(analysis.measure("b-union", "length") == Approx(3.0 * side / height));
  }
}

TEST_CASE("a ring of disks has a polygon as its axis") {
  for (const std::size_t m : {3U, 5U, 8U}) {
    std::vector<Disk> disks;
    for (std::size_t i = 0; i < m; ++i) {
      const double t = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(m);
      disks.push_back(
          {{10.0 * std::cos(t), 10.0 * std::sin(t)}, 10.0 * std::sin(kPi / static_cast<double>(m)) * 1.05});
    }
    const Analysis analysis(balls_of(disks), Precision::exact, true);
    CHECK(analysis.count("b-union", "cycles") == 1);
    CHECK(analysis.count("b-union", "edges") == static_cast<std::int64_t>(m));
    CHECK(analysis.measure("b-union", "length") ==
          Approx(20.0 * static_cast<double>(m) * std::sin(kPi / static_cast<double>(m))));
  }
}

TEST_CASE("on dense shapes the theorem holds, and the certified shortcut is what the exact pipeline finds") {
  for (const double epsilon : {0.25, 0.1}) {
    for (const TestShape& shape : oracle_shapes(epsilon, {.offset = 0.3, .jitter = 0.1})) {
      INFO(shape.name << " epsilon " << epsilon);
      Analysis analysis(shape.data, Precision::exact, true);
      const AUnion& balls = analysis.get<AUnion>();
      REQUIRE(balls.rung() == UnionRung::shortcut);
      CHECK(analysis.light() == TheoremLight::green);
      CHECK(analysis.count("a-union", "foreign_v_points") == 0);
      CHECK(analysis.count("a-union", "chi") == analysis.count("a-union", "chi_dual"));
      CHECK(analysis.count("a-union", "components") == static_cast<std::int64_t>(shape.expected.components));
      CHECK(analysis.count("a-union", "cycles") == static_cast<std::int64_t>(shape.expected.cycles));
      CHECK(analysis.measure("a-union", "length") ==
            Approx(analysis.measure("medial-axis", "length")).epsilon(1e-12));
      const auto v_points = v_points_of(balls);
      const auto axis = axis_between_balls(balls);
      const std::vector<std::string_view> counters{"balls",         "dual_edges", "dual_singular", "dual_regular",
                                                   "dual_interior", "dual_faces", "v_points",      "isolated"};
      std::vector<std::int64_t> by_shortcut;
      for (const auto& key : counters) by_shortcut.push_back(analysis.count("a-union", key));

      analysis.choose(Precision::exact, false);
      REQUIRE(balls.rung() == UnionRung::rational);
      CHECK(v_points_of(balls) == v_points);
      CHECK(axis_between_balls(balls) == axis);
      for (std::size_t i = 0; i < counters.size(); ++i) {
        INFO(counters[i]);
        CHECK(analysis.count("a-union", counters[i]) == by_shortcut[i]);
      }
      for (const char* key :
           {"sign_flips", "negative_faces", "edges_without_sample", "lost_crossings", "contradictions"})
        CHECK(analysis.count("a-union", key) == 0);
      CHECK(analysis.light() == TheoremLight::green);
    }
  }
}

TEST_CASE("on dense glyphs, corners and all, the two axes are one") {
  struct Glyph {
    const char* file;
    std::int64_t components, cycles;
  };
  for (const Glyph& glyph : {Glyph{"tests/data/glyph_dejavusans_B_1000.poff", 1, 2},
                             Glyph{"tests/data/glyph_dejavusans_ampersand_2000.poff", 1, 1}}) {
    INFO(glyph.file);
    auto file = read_sample_file(glyph.file);
    REQUIRE(file.has_value());
    Analysis analysis(file->data, Precision::exact, true, {"medial-axis", "a-ball-medial-axis", "axis-difference"});
    for (const bool use_shortcut : {true, false}) {
      analysis.choose(Precision::exact, use_shortcut);
      const AUnion& balls = analysis.get<AUnion>();
      REQUIRE(balls.rung() == (use_shortcut ? UnionRung::shortcut : UnionRung::rational));
      CHECK(analysis.count("axis-difference", "only_one_step") == 0);
      CHECK(analysis.count("axis-difference", "only_union") == 0);
      CHECK(analysis.count("a-union", "components") == glyph.components);
      CHECK(analysis.count("a-union", "cycles") == glyph.cycles);
      CHECK(analysis.count("a-union", "chi") == analysis.count("a-union", "chi_dual"));
      CHECK(analysis.measure("a-union", "length") ==
            Approx(analysis.measure("medial-axis", "length")).epsilon(1e-12));
      // The v-points are the samples that two balls or more touch.
      std::map<SiteSlot, int> touching;
      std::vector<TouchedSample> samples;
      for (const FamilySlot row : slots_below<FamilySlot>(balls.family().rows())) {
        samples.clear();
        if (balls.family().is_ball(row)) balls.family().touched_samples(row, samples);
        for (const TouchedSample& sample : samples) ++touching[sample.site];
      }
      std::set<SiteSlot> several;
      for (const auto& [site, count] : touching)
        if (count >= 2) several.insert(site);
      CHECK(v_points_of(balls) == several);
    }
  }
}

TEST_CASE("the precision difference is what a number type misses of the exact dual complex, and no more") {
  const std::initializer_list<std::string_view> layers{"a-ball-medial-axis", "b-ball-medial-axis",
                                                       "precision-difference"};
  for (const TestShape& shape : oracle_shapes(0.25, {.offset = 0.3, .jitter = 0.1})) {
    INFO(shape.name);
    Analysis analysis(shape.data, Precision::exact, true, layers);
    const std::int64_t faces = analysis.count("a-union", "dual_faces");
    const std::int64_t edges = analysis.count("a-union", "dual_edges");
    for (const char* key : {"edges_missed", "edges_invented", "edges_of_other_class", "faces_missed"})
      CHECK(analysis.count("a-precision-difference", key) == 0);
    for (const Precision precision : {Precision::fast, Precision::naive}) {
      analysis.choose(precision, false);
      INFO(id_of(precision));
      CHECK(analysis.count("a-precision-difference", "faces_missed") -
                analysis.count("a-precision-difference", "faces_invented") ==
            faces - analysis.count("a-union", "dual_faces"));
      CHECK((analysis.count("a-precision-difference", "edges_missed") > 0 ||
             edges == analysis.count("a-union", "dual_edges")));
      CHECK(analysis.count("a-precision-difference", "edges_of_other_class") > 0);
    }
  }
  // Disks that doubles hold are judged rightly by predicates that are exact on doubles.
  Rng rng(9);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Disk> disks(8);
    for (Disk& disk : disks)
      disk = {{static_cast<double>(rng.below(6)), static_cast<double>(rng.below(6))},
              static_cast<double>(1 + rng.below(3))};
    const Analysis analysis(balls_of(disks), Precision::fast, true, layers);
    for (const char* key :
         {"edges_missed", "edges_invented", "edges_of_other_class", "faces_missed", "faces_invented"})
      CHECK(analysis.count("b-precision-difference", key) == 0);
  }
}

TEST_CASE("algebraic numbers all the way give the shortcut exactly") {
  Analysis analysis(ellipse(2, 1, 60, {.offset = 0.123}).data, Precision::exact, true);
  const AUnion& balls = analysis.get<AUnion>();
  const auto v_points = v_points_of(balls);
  const auto axis = axis_between_balls(balls);
  const std::int64_t faces = analysis.count("a-union", "dual_faces");
  analysis.choose(Precision::exact_roots, true);
  REQUIRE(balls.rung() == UnionRung::roots);
  CHECK(v_points_of(balls) == v_points);
  CHECK(axis_between_balls(balls) == axis);
  CHECK(analysis.count("a-union", "dual_faces") == faces);
  CHECK(analysis.light() == TheoremLight::green);
}

TEST_CASE("plain doubles end, lie, and are found out") {
  Analysis analysis(ellipse(2, 1, 400, {.offset = 0.123}).data, Precision::naive, true);
  CHECK(analysis.get<AUnion>().rung() == UnionRung::naive);
  CHECK(analysis.light() == TheoremLight::red);
  CHECK(analysis.count("a-union", "sign_flips") > 100);
  // The one-step axis beside it is right.
  CHECK(analysis.count("medial-axis", "edges") == 397);
  analysis.choose(Precision::exact, true);
  CHECK(analysis.light() == TheoremLight::green);
}

TEST_CASE("where samples are too few for the theorem the light is yellow, and the exact union consistent") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    INFO("seed " << seed);
    SampleData data;
    data.positions = uniform_square(60, seed);
    Analysis analysis(data, Precision::exact, true);
    CHECK(analysis.light() == TheoremLight::yellow);
    CHECK_FALSE(analysis.get<AxisCertificate>().is_certified());
    CHECK(analysis.get<AUnion>().rung() != UnionRung::shortcut);
    CHECK(analysis.count("a-union", "foreign_v_points") >= 1);
    CHECK(analysis.count("a-union", "chi") == analysis.count("a-union", "chi_dual"));
    for (const char* key : {"sign_flips", "lost_crossings", "contradictions", "negative_radicands"})
      CHECK(analysis.count("a-union", key) == 0);
  }
}

TEST_CASE("cocircular samples count as touched by one ball") {
  // Each has four samples on one circle. Taken by its triangles, some of these balls seem to share no sample with a
  // ball that crosses them in one; taken as a whole the theorem holds.
  const std::vector<std::vector<std::pair<int, int>>> fixtures{
      {{4, 3}, {5, 38}, {6, 16}, {16, 35}, {22, 16}, {23, 29}, {24, 3}},
      {{9, 8}, {10, 32}, {13, 35}, {20, 0}, {30, 6}, {39, 15}},
      {{3, 9}, {4, 28}, {4, 35}, {12, 0}, {15, 18}, {17, 23}, {21, 12}, {21, 39}, {24, 13}, {27, 6}}};
  for (const auto& fixture : fixtures) {
    Analysis analysis(points_of(fixture), Precision::exact, true);
    CHECK(analysis.light() == TheoremLight::green);
    const auto v_points = v_points_of(analysis.get<AUnion>());
    for (const Precision precision : {Precision::exact, Precision::exact_roots}) {
      analysis.choose(precision, false);
      CHECK(analysis.light() == TheoremLight::green);
      CHECK(v_points_of(analysis.get<AUnion>()) == v_points);
      CHECK(analysis.count("a-union", "foreign_v_points") == 0);
      CHECK(analysis.measure("a-union", "length") ==
            Approx(analysis.measure("medial-axis", "length")).epsilon(1e-12));
    }
  }
}

TEST_CASE("an exact circle is one ball and one point") {
  std::vector<std::pair<int, int>> points;
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) points.emplace_back(x, y);
  REQUIRE(points.size() == 36);
  for (const bool use_shortcut : {true, false}) {
    const Analysis analysis(points_of(points), Precision::exact, use_shortcut);
    CHECK(analysis.light() == TheoremLight::green);
    CHECK(analysis.count("a-union", "balls") == 1);
    CHECK(analysis.count("a-union", "isolated") == 1);
    CHECK(analysis.count("a-union", "v_points") == 0);
    CHECK(analysis.count("a-union", "nodes") == 1);
    CHECK(analysis.measure("a-union", "area") == Approx(65.0 * 65.0 * kPi));
  }
}

TEST_CASE("exact and exact with roots agree on balls with many coincidences") {
  Rng rng(7);
  for (int trial = 0; trial < 150; ++trial) {
    const auto whole = [&rng](int most) { return std::floor(rng.uniform() * (most + 0.999)); };
    std::vector<Disk> disks(static_cast<std::size_t>(1 + whole(7)));
    for (Disk& disk : disks) disk = {{whole(5), whole(5)}, 1 + whole(2)};
    INFO("trial " << trial);
    const Analysis mixed(balls_of(disks), Precision::exact, true);
    const Analysis roots(balls_of(disks), Precision::exact_roots, true);
    for (const char* key : {"visible", "hidden", "dual_singular", "dual_regular", "dual_faces", "isolated",
                            "v_points", "components", "cycles", "edges", "leaves", "branch_points"}) {
      INFO(key);
      CHECK(mixed.count("b-union", key) == roots.count("b-union", key));
    }
    CHECK(mixed.count("b-union", "chi") == mixed.count("b-union", "chi_dual"));
    for (const char* key : {"lost_crossings", "contradictions", "negative_radicands"})
      CHECK(mixed.count("b-union", key) == 0);
    CHECK(mixed.measure("b-union", "length") == Approx(roots.measure("b-union", "length")).margin(1e-9));
  }
}

TEST_CASE("the boundary is drawn in closed curves as long as the perimeter") {
  Rng rng(9);
  SampleData data = ellipse(2, 1, 200, {.offset = 0.123}).data;
  for (int i = 0; i < 40; ++i) data.balls.push_back({{10 * rng.uniform(), 10 * rng.uniform()}, 0.2 + rng.uniform()});
  // Alone, twice and within another; touching from outside and from inside.
  for (const Disk& disk : {Disk{{20, 0}, 1}, {{20, 0}, 1}, {{20.5, 0}, 0.25}, {{22, 0}, 1}, {{22.5, 0}, 0.5}})
    data.balls.push_back(disk);
  TestBench bench;
  bench.load(data);
  for (const std::string family : {"a", "b"}) {
    const auto arcs = bench.instances(family + "-union-boundary", PrimitiveKind::arc);
    REQUIRE_FALSE(arcs.empty());
    double length = 0.0;
    std::map<std::pair<double, double>, int> ends;
    for (std::size_t at = 0; at < arcs.size(); at += stride_of(PrimitiveKind::arc)) {
      const double* const v = arcs.data() + at;
      const Arc arc{{v[0], v[1]}, v[2], {v[3], v[4]}, {v[5], v[6]}};
      length += arc.radius * sweep_of(arc);
      CHECK(distance(arc.center, arc.from) == Approx(arc.radius).epsilon(1e-9));
      CHECK(distance(arc.center, arc.to) == Approx(arc.radius).epsilon(1e-9));
      ++ends[{v[3], v[4]}];
      --ends[{v[5], v[6]}];
    }
    CHECK(length == Approx(bench.measure(family + "-union", "perimeter")).epsilon(1e-12));
    CHECK(std::ranges::all_of(ends, [](const auto& end) { return end.second == 0; }));
  }
}

TEST_CASE("the measures of a union agree with counting points") {
  Rng rng(3);
  std::vector<Disk> disks(25);
  for (Disk& disk : disks) disk = {{10 * rng.uniform(), 10 * rng.uniform()}, 0.3 + rng.uniform()};
  const Analysis analysis(balls_of(disks), Precision::fast, true);
  constexpr int kGrid = 1200;
  std::size_t inside = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vec2 p{-2.0 + 14.0 * (i + 0.5) / kGrid, -2.0 + 14.0 * (j + 0.5) / kGrid};
      inside +=
          std::ranges::any_of(disks, [p](const Disk& d) { return distance(p, d.center) <= d.radius; }) ? 1U : 0U;
    }
  }
  const double cell = (14.0 / kGrid) * (14.0 / kGrid);
  CHECK(analysis.measure("b-union", "area") == Approx(static_cast<double>(inside) * cell).epsilon(2e-3));
}

TEST_CASE("as many balls as several threads share have a union without contradictions, each time the same") {
  Rng rng(11);
  SampleData data;
  for (int i = 0; i < 40000; ++i)
    data.balls.push_back({{rng.uniform(0.0, 200.0), rng.uniform(0.0, 200.0)}, rng.uniform(0.3, 0.8)});
  Analysis analysis(data, Precision::fast, false, {"b-ball-medial-axis"});
  CHECK(analysis.count("b-union", "balls") == 40000);
  CHECK(analysis.count("b-union", "hidden") > 1000);
  CHECK(analysis.count("b-union", "contradictions") == 0);
  CHECK(analysis.count("b-union", "lost_crossings") == 0);
  CHECK(analysis.count("b-union", "chi") == analysis.count("b-union", "chi_dual"));
  const std::int64_t v_points = analysis.count("b-union", "v_points");
  const double length = analysis.measure("b-union", "length");
  const double area = analysis.measure("b-union", "area");
  analysis.choose(Precision::naive, false);
  analysis.choose(Precision::fast, false);
  CHECK(analysis.count("b-union", "v_points") == v_points);
  CHECK(analysis.measure("b-union", "length") == length);
  CHECK(analysis.measure("b-union", "area") == area);
}

TEST_CASE("circumdisks that several threads look at are those of one") {
  Analysis analysis({benchmark_curve(40000), {}, {}}, Precision::fast, false, {"a-ball-medial-axis"});
  const std::int64_t balls = analysis.count("a-union", "balls");
  const double length = analysis.measure("a-union", "length");
  CHECK(balls > 39000);
  for (int i = 0; i < 3; ++i) {
    analysis.choose(Precision::fast, true);
    CHECK(analysis.count("a-union", "balls") == balls);
    analysis.choose(Precision::fast, false);
    CHECK(analysis.measure("a-union", "length") == length);
  }
}

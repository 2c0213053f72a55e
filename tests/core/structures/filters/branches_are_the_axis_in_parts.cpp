// SPDX-License-Identifier: GPL-3.0-or-later
// Branches of the axis: their lengths add up, their counts are those of the graph, their measures follow formulas.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/rng.h"
#include "core/structures/filters/axis_branches.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

std::vector<AxisBranch> branches(const TestBench& bench, bool of_angle = false, double least = 0.0) {
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& angle = bench.get<AngleAxis>();
  return branches_of(of_angle ? static_cast<const AxisFilter&>(angle) : lambda, bench.get<InnerBalls>(), lambda,
                     angle, least);
}

/// Components of the branches, which meet at their nodes. Ends that a filter cuts meet nothing.
std::int64_t components(const std::vector<AxisBranch>& found) {
  std::map<FaceSlot, std::size_t> number_of;
  DisjointSets<RowNumber> sets(3 * found.size());
  std::set<RowNumber> roots;
  const auto number = [&](std::size_t i, const AxisBranch::End& end, std::size_t own) {
    const std::size_t at = 3 * i + own;
    return static_cast<RowNumber>(end.node == kNoSlot ? at : number_of.try_emplace(end.node, at).first->second);
  };
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const RowNumber end : {number(i, found[i].from, 1), number(i, found[i].to, 2)})
      sets.join(sets.root(static_cast<RowNumber>(3 * i)), sets.root(end));
  for (std::size_t i = 0; i < found.size(); ++i) roots.insert(sets.root(static_cast<RowNumber>(3 * i)));
  return std::ssize(roots);
}

ComputationSettings limits(double lambda, double angle, bool keep_topology) {
  ComputationSettings out;
  out[Parameter::lambda_limit] = lambda;
  out[Parameter::angle_limit] = angle;
  out[Parameter::keep_topology] = keep_topology ? 1.0 : 0.0;
  return out;
}

void check_branches(const TestBench& bench, bool of_angle) {
  const char* const structure = of_angle ? "angle-axis" : "lambda-axis";
  double length = 0.0;
  std::int64_t edges = 0;
  std::int64_t ends = 0;
  std::int64_t points = 0;
  std::set<EdgeSlot> seen;
  for (const AxisBranch& branch : branches(bench, of_angle)) {
    length += branch.length;
    edges += static_cast<std::int64_t>(branch.edges.size());
    seen.insert(branch.edges.begin(), branch.edges.end());
    points += branch.edges.empty() ? 1 : 0;
    for (const BranchEndKind kind : {branch.from.kind, branch.to.kind})
      ends += kind == BranchEndKind::leaf || kind == BranchEndKind::cut ? 1 : 0;
    for (const double x :
         {branch.from.place.x, branch.from.place.y, branch.to.place.x, branch.to.place.y, branch.length,
          branch.radius_least, branch.radius_mean, branch.radius_largest, branch.lambda, branch.angle})
      REQUIRE(std::isfinite(x));
    REQUIRE(branch.radius_least <= branch.radius_mean);
    REQUIRE(branch.radius_mean <= branch.radius_largest);
    REQUIRE(branch.angle <= 90.0);
    if (!branch.edges.empty()) REQUIRE(branch.lambda <= branch.radius_largest * (1.0 + 1e-9));
  }
  REQUIRE(length == Approx(bench.measure(structure, "length")).epsilon(1e-12).margin(1e-300));
  REQUIRE(edges == bench.count(structure, "edges"));
  REQUIRE(seen.size() == static_cast<std::size_t>(edges));
  REQUIRE(ends == bench.count(structure, "leaves"));
  REQUIRE(points == bench.count(structure, "isolated"));
}

/// Edges by the places of their samples, in order.
std::vector<PlaceEdge> edges_of(const TestBench& bench, const AxisBranch& branch) {
  const auto& delaunay = bench.get<Delaunay>();
  std::vector<PlaceEdge> out;
  for (const EdgeSlot edge : branch.edges)
    out.push_back(place_edge(delaunay.site_position(delaunay.edge(edge).v[0]),
                             delaunay.site_position(delaunay.edge(edge).v[1])));
  return out;
}

void check_same(const TestBench& one, const AxisBranch& a, const TestBench& other, const AxisBranch& b) {
  CHECK(a.from.place == b.from.place);
  CHECK(a.to.place == b.to.place);
  CHECK(a.from.kind == b.from.kind);
  CHECK(a.to.kind == b.to.kind);
  CHECK(a.length == b.length);
  CHECK(a.radius_mean == b.radius_mean);
  CHECK(edges_of(one, a) == edges_of(other, b));
}

}  // namespace

TEST_CASE("branches hold each kept edge once, and as many ends and points as the statistics count") {
  std::vector<std::vector<Vec2>> inputs;
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (const DegenerateInput& input : degenerate_inputs()) inputs.push_back(input.positions);
  Rng rng(3);
  std::vector<Vec2> random;
  for (int i = 0; i < 200; ++i) random.push_back({rng.uniform(), rng.uniform()});
  inputs.push_back(random);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    TestBench bench;
    bench.show({"lambda-medial-axis", "angle-medial-axis"});
    bench.replace(inputs[i]);
    const double largest = bench.get<LambdaAxis>().reason().empty() ? bench.measure("lambda-axis", "largest") : 1.0;
    for (const double share : {0.0, 0.1, 0.5, 1.0}) {
      for (const bool keep : {false, true}) {
        INFO("input " << i << " share " << share << " topology " << keep);
        bench.choose(limits(share * largest, 90.0 * share, keep));
        check_branches(bench, false);
        check_branches(bench, true);
      }
    }
  }
}

TEST_CASE("the largest lambda and angle of a branch may be those of a node") {
  // The circle through four corners of a house: of an acute triangle lambda is the radius.
  TestBench bench;
  bench.show({"lambda-medial-axis", "angle-medial-axis"});
  bench.replace({{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}});
  double lambda = 0.0;
  double radius = 0.0;
  for (const AxisBranch& branch : branches(bench)) {
    lambda = std::max(lambda, branch.lambda);
    radius = std::max(radius, branch.radius_largest);
  }
  CHECK(radius == 2.5);
  CHECK(lambda == 2.5);
  double largest = 0.0;
  for (const FaceSlot face : bench.get<Delaunay>().face_slots())
    if (bench.get<MedialAxis>().is_node(face)) largest = std::max(largest, bench.get<LambdaAxis>().value(face));
  CHECK(lambda == largest);
}

TEST_CASE("a rounded rectangle has a core and four branches of the lengths and radii of the formula") {
  TestBench bench;
  bench.show({"lambda-medial-axis", "angle-medial-axis"});
  bench.replace(rounded_rectangle(3.0, 2.0, 0.5, 0.05, {0.3, 0.0, 1}).data.positions);
  // Hairs at the samples of the caps are shorter than anything else.
  bench.choose(limits(0.3, 0.0, true));
  std::vector<AxisBranch> found = branches(bench);
  std::erase_if(found, [](const AxisBranch& branch) { return branch.length < 0.05; });
  REQUIRE(found.size() == 5);
  const double diagonal = std::sqrt(2.0) * 1.5;
  for (const AxisBranch& branch : found) {
    if (branch.from.kind == BranchEndKind::junction && branch.to.kind == BranchEndKind::junction) {
      CHECK(branch.length == Approx(2.0).margin(0.1));
      CHECK(branch.radius_mean == Approx(2.0).margin(0.02));
      CHECK(branch.angle == Approx(90.0).margin(2.0));
      CHECK(branch.lambda == Approx(2.0).margin(0.02));
    } else {
      CHECK(branch.length == Approx(diagonal).margin(0.15));
      CHECK(branch.radius_least == Approx(0.5).margin(0.1));
      CHECK(branch.radius_largest == Approx(2.0).margin(0.05));
      CHECK(branch.radius_mean == Approx(1.25).margin(0.1));
    }
  }
}

TEST_CASE("an annulus is one closed branch, two circles are two points, and the table has no trace of history") {
  TestBench bench;
  bench.show({"lambda-medial-axis", "angle-medial-axis"});
  bench.replace(annulus_aligned(1.0, 2.0, 16).data.positions);
  std::vector<AxisBranch> found = branches(bench);
  REQUIRE(found.size() == 1);
  CHECK(found[0].edges.size() == static_cast<std::size_t>(bench.count("lambda-axis", "edges")));
  CHECK(found[0].from.kind == BranchEndKind::none);
  CHECK(found[0].from.place == found[0].to.place);
  CHECK(found[0].radius_least == Approx(0.5).margin(0.1));

  std::vector<Vec2> two = lattice_circle().positions;
  for (const Vec2 p : lattice_circle().positions) two.push_back(p + Vec2{400, 30});
  bench.replace(two);
  found = branches(bench);
  REQUIRE(found.size() == 2);
  CHECK(found[0].length == 0.0);
  CHECK(found[0].radius_mean == Approx(65.0));

  Rng rng(5);
  std::vector<Vec2> samples;
  for (int i = 0; i < 80; ++i) samples.push_back({rng.uniform(), rng.uniform()});
  bench.replace(samples);
  for (int i = 0; i < 30; ++i) bench.move(bench.ids()[rng.below(80)], {rng.uniform(), rng.uniform()});
  TestBench fresh;
  fresh.show({"lambda-medial-axis", "angle-medial-axis"});
  std::vector<Vec2> reversed = bench.positions();
  std::ranges::reverse(reversed);
  fresh.replace(reversed);
  const auto a = branches(bench);
  const auto b = branches(fresh);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) check_same(bench, a[i], fresh, b[i]);
}

TEST_CASE("circles and a stadium in rounded coordinates have as many branches as their formulas say") {
  const auto arc = [](std::vector<Vec2>& out, Vec2 middle, double begin, double end) {
    constexpr int kSteps = 100;
    for (int i = 0; i < kSteps; ++i) {
      const double t = std::numbers::pi * (begin + (end - begin) * i / kSteps);
      out.push_back(middle + Vec2{std::cos(t), std::sin(t)});
    }
  };
  for (const Vec2 offset : {Vec2{0, 0}, Vec2{1e4, -3e4}}) {
    std::vector<Vec2> samples;
    arc(samples, offset + Vec2{10, 0}, 0.0, 2.0);
    arc(samples, offset + Vec2{20, 9}, 0.0, 2.0);
    arc(samples, offset + Vec2{-1.5, 0}, 0.5, 1.5);
    for (int i = 0; i < 100; ++i) samples.push_back(offset + Vec2{-1.5 + 0.03 * i, -1});
    arc(samples, offset + Vec2{1.5, 0}, -0.5, 0.5);
    for (int i = 0; i < 100; ++i) samples.push_back(offset + Vec2{1.5 - 0.03 * i, 1});
    TestBench bench;
    bench.show({"lambda-medial-axis", "angle-medial-axis"});
    bench.replace(samples);
    REQUIRE(branches(bench).size() > 10);
    const std::vector<AxisBranch> found = branches(bench, false, kLeastBranch);
    REQUIRE(found.size() == 3);
    CHECK(found[0].length == Approx(3.0));
    CHECK(found[0].from.kind == BranchEndKind::leaf);
    CHECK(found[0].to.kind == BranchEndKind::leaf);
    for (const std::size_t circle : {1U, 2U}) {
      CHECK(found[circle].edges.empty());
      CHECK(found[circle].radius_mean == Approx(1.0));
      CHECK(distance(found[circle].from.place, offset + (circle == 1 ? Vec2{10, 0} : Vec2{20, 9})) < 1e-6);
    }
  }
}

TEST_CASE("contracting short branches keeps components, and leaves longer branches alone") {
  std::vector<std::vector<Vec2>> inputs;
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (const DegenerateInput& input : degenerate_inputs()) inputs.push_back(input.positions);
  Rng rng(4);
  for (int round = 0; round < 4; ++round) {
    std::vector<Vec2>& random = inputs.emplace_back();
    for (int i = 0; i < 200; ++i) random.push_back({rng.uniform(), rng.uniform()});
  }
  std::size_t contracted = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    TestBench bench;
    bench.show({"lambda-medial-axis", "angle-medial-axis"});
    bench.replace(inputs[i]);
    const std::vector<AxisBranch> all = branches(bench);
    for (const double least : {1e-6, 0.1, 0.5}) {
      INFO("input " << i << " least " << least);
      const std::vector<AxisBranch> found = branches(bench, false, least);
      CHECK(components(found) == bench.count("lambda-axis", "components"));
      std::set<EdgeSlot> left;
      for (const AxisBranch& branch : found) {
        if (!branch.edges.empty()) CHECK(branch.length > least * branch.radius_largest);
        left.insert(branch.edges.begin(), branch.edges.end());
      }
      for (const AxisBranch& branch : all) {
        const bool is_short = branch.length <= least * branch.radius_largest;
        for (const EdgeSlot edge : branch.edges) CHECK(left.contains(edge) != is_short);
        contracted += is_short ? 1 : 0;
      }
    }
  }
  CHECK(contracted > 300);
}

TEST_CASE("a closed branch and a loop at a junction go the same way whatever the history") {
  // A ring, and a ring with a tail: a loop that begins and ends at one junction.
  std::vector<std::vector<Vec2>> inputs{annulus_aligned(1.0, 2.0, 16).data.positions};
  std::vector<Vec2> tailed;
  Rng jitter(8);
  for (int i = 0; i < 40; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + 0.3 * jitter.uniform()) / 40.0;
    tailed.push_back({2.0 * std::cos(t), 2.0 * std::sin(t)});
    tailed.push_back({std::cos(t), std::sin(t)});
  }
  inputs.push_back(tailed);
  std::size_t loops = 0;
  for (const std::vector<Vec2>& input : inputs) {
    Rng rng(6);
    TestBench bench;
    bench.show({"lambda-medial-axis", "angle-medial-axis"});
    bench.replace(input);
    bench.choose(limits(0.4, 0.0, true));
    for (int round = 0; round < 8; ++round) {
      // There and back again: the rows are others, the samples the same.
      for (int i = 0; i < 10; ++i) {
        const SampleId id = bench.ids()[rng.below(bench.ids().size())];
        const Vec2 place = bench.document().position(bench.document().slot_of(id));
        bench.remove({id});
        bench.insert({place});
      }
      TestBench fresh;
      fresh.show({"lambda-medial-axis", "angle-medial-axis"});
      std::vector<Vec2> shuffled = bench.positions();
      for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[rng.below(i)]);
      fresh.replace(shuffled);
      fresh.choose(limits(0.4, 0.0, true));
      const auto a = branches(bench);
      const auto b = branches(fresh);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        check_same(bench, a[i], fresh, b[i]);
        loops += a[i].from.place == a[i].to.place && a[i].edges.size() > 2 ? 1U : 0U;
      }
    }
  }
  CHECK(loops >= 16);
}

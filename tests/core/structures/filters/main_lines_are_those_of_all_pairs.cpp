// SPDX-License-Identifier: GPL-3.0-or-later
// Main lines of random graphs against all pairs of nodes, and pruning against its definition.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/filters/paths/axis_paths.h"
#include "core/structures/filters/paths/branch_pruning.h"
#include "tests/support/effort.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct RandomGraph {
  std::size_t nodes = 0;
  std::vector<PathEdge> edges;
};

/// A tree whose edges have random lengths, with further edges and loops.
RandomGraph random_graph(Rng& rng, std::size_t nodes, std::size_t further) {
  RandomGraph out{nodes, {}};
  const auto any = [&](std::size_t below) { return static_cast<std::uint32_t>(rng.below(below)); };
  for (std::uint32_t node = 1; node < nodes; ++node) out.edges.push_back({any(node), node, rng.uniform(0.1, 2.0)});
  for (std::size_t i = 0; i < further; ++i) out.edges.push_back({any(nodes), any(nodes), rng.uniform(0.1, 2.0)});
  return out;
}

std::vector<std::vector<double>> all_distances(const RandomGraph& graph) {
  std::vector<std::vector<double>> out(graph.nodes, std::vector<double>(graph.nodes, kFar));
  for (std::size_t i = 0; i < graph.nodes; ++i) out[i][i] = 0.0;
  for (const PathEdge& edge : graph.edges) {
    out[edge.from][edge.to] = std::min(out[edge.from][edge.to], edge.length);
    out[edge.to][edge.from] = out[edge.from][edge.to];
  }
  for (std::size_t k = 0; k < graph.nodes; ++k)
    for (std::size_t i = 0; i < graph.nodes; ++i)
      for (std::size_t j = 0; j < graph.nodes; ++j) out[i][j] = std::min(out[i][j], out[i][k] + out[k][j]);
  return out;
}

std::vector<std::size_t> degrees(const RandomGraph& graph) {
  std::vector<std::size_t> out(graph.nodes, 0);
  for (const PathEdge& edge : graph.edges) {
    ++out[edge.from];
    ++out[edge.to];
  }
  return out;
}

void check_is_walk(const PathGraph& graph, const AxisPath& line, std::set<std::uint32_t>& used) {
  REQUIRE_FALSE(line.steps.empty());
  double length = 0.0;
  for (std::size_t i = 0; i < line.steps.size(); ++i) {
    REQUIRE(used.insert(line.steps[i].edge).second);
    if (i != 0) REQUIRE(graph.tail(line.steps[i]) == graph.head(line.steps[i - 1]));
    length += graph.length(line.steps[i]);
  }
  CHECK(line.length == Approx(length).epsilon(1e-12));
  if (line.is_closed) CHECK(graph.tail(line.steps.front()) == graph.head(line.steps.back()));
}

}  // namespace

TEST_CASE("the first line is the longest of the shortest ways between free ends, and lines share no edge") {
  Rng rng(71);
  const std::uint64_t cases = 300 * effort();
  for (std::uint64_t round = 0; round < cases; ++round) {
    const RandomGraph graph = random_graph(rng, 2 + rng.below(20), rng.below(2) == 0 ? 0 : rng.below(8));
    const PathGraph paths_graph(graph.nodes, graph.edges);
    AxisPaths paths(paths_graph);
    const auto distances = all_distances(graph);
    const auto degree = degrees(graph);
    double longest = 0.0;
    std::size_t ends = 0;
    for (std::size_t i = 0; i < graph.nodes; ++i) {
      CHECK(paths.is_free_end(static_cast<std::uint32_t>(i)) == (degree[i] == 1));
      ends += degree[i] == 1 ? 1U : 0U;
      for (std::size_t j = 0; j < graph.nodes; ++j)
        if (degree[i] == 1 && degree[j] == 1) longest = std::max(longest, distances[i][j]);
    }
    JobControl job;
    const auto lines = paths.main_lines(1000, job);
    REQUIRE_FALSE(lines.empty());
    std::set<std::uint32_t> used;
    std::set<std::uint32_t> nodes;
    for (const AxisPath& line : lines) {
      check_is_walk(paths_graph, line, used);
      if (!nodes.empty()) CHECK(nodes.contains(paths_graph.tail(line.steps.front())));
      for (const PathStep step : line.steps) nodes.insert({paths_graph.tail(step), paths_graph.head(step)});
      CHECK(line.shape == 0);
    }
    CHECK(used.size() == graph.edges.size());
    if (ends >= 2) CHECK(lines.front().length == Approx(longest).epsilon(1e-12));
    CHECK(lines.front().is_closed == (ends == 0));
    // In a tree each further line is the longest that is left.
    if (graph.edges.size() + 1 == graph.nodes)
      for (std::size_t i = 2; i < lines.size(); ++i) CHECK(lines[i].length <= lines[i - 1].length);
    const auto some = paths.main_lines(2, job);
    CHECK(some.size() == std::min<std::size_t>(2, lines.size()));
    CHECK(some.front().steps == lines.front().steps);

    const auto a = static_cast<std::uint32_t>(rng.below(graph.nodes));
    const auto b = static_cast<std::uint32_t>(rng.below(graph.nodes));
    if (a == b) continue;
    const auto way = paths.between(a, b);
    REQUIRE(way);
    std::set<std::uint32_t> none;
    check_is_walk(paths_graph, *way, none);
    CHECK(way->length == Approx(distances[a][b]).epsilon(1e-12));
    CHECK(paths_graph.tail(way->steps.front()) == a);
    CHECK(paths_graph.head(way->steps.back()) == b);
  }
}

TEST_CASE("shapes without ends have closed lines, and those with one end a line that meets itself") {
  JobControl job;
  // Two loops joined by a bridge: the line is the longer loop, although the bridge is longer.
  AxisPaths glasses(PathGraph(2, {{0, 0, 3.0}, {0, 1, 9.0}, {1, 1, 4.0}}));
  const auto loops = glasses.main_lines(3, job);
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].is_closed);
  CHECK(loops[0].length == 4.0);
  CHECK(loops[1].length == 12.0);  // the bridge and the other loop
  CHECK_FALSE(loops[1].is_closed);

  AxisPaths racket(PathGraph(3, {{0, 1, 2.0}, {1, 2, 3.0}, {2, 1, 4.0}}));
  const auto line = racket.main_lines(1, job);
  REQUIRE(line.size() == 1);
  CHECK(line[0].length == 9.0);
  CHECK_FALSE(line[0].is_closed);

  AxisPaths apart(PathGraph(5, {{0, 1, 2.0}, {3, 4, 5.0}}));
  CHECK(apart.shape_count() == 2);
  CHECK(apart.main_lines(7, job).size() == 2);
  CHECK_FALSE(apart.between(0, 3));
  CHECK_FALSE(apart.between(0, 2));
  CHECK(AxisPaths(PathGraph(0, {})).main_lines(1, job).empty());

  job.stop_at_look(1);
  CHECK_THROWS_AS(apart.main_lines(1, job), Cancelled);
}

TEST_CASE("arms that show little beyond their ball go, twins together, and the rest is measured again") {
  const auto kept = [](std::size_t nodes, std::vector<PathEdge> edges, const std::vector<double>& radii,
                       double limit) { return salient_branches(PathGraph(nodes, std::move(edges)), radii, limit); };
  using Flags = std::vector<std::uint8_t>;
  // A rectangle of 8 by 2: a trunk of 6 with corners of length sqrt 2 at each end.
  const double corner = std::sqrt(2.0);
  const std::vector<PathEdge> rectangle{{0, 1, 6.0}, {0, 2, corner}, {0, 3, corner}, {1, 4, corner}, {1, 5, corner}};
  const std::vector<double> radii{1.0, 1.0, 0.0, 0.0, 0.0, 0.0};
  CHECK(kept(6, rectangle, radii, 0.42) == Flags{1, 0, 0, 0, 0});
  CHECK(kept(6, rectangle, radii, 0.41) == Flags{1, 1, 1, 1, 1});
  CHECK(kept(6, rectangle, radii, 0.0) == Flags{1, 1, 1, 1, 1});
  // A square is a point, and so is a rectangle that is hardly longer.
  std::vector<PathEdge> square = rectangle;
  square.front().length = 0.05;
  CHECK(kept(6, square, radii, 0.5) == Flags{0, 0, 0, 0, 0});
  CHECK(kept(6, square, radii, 0.46) == Flags{1, 0, 0, 0, 0});
  // A spur of noise leaves the trunk whole, whichever end is nearer.
  CHECK(kept(4, {{0, 1, 0.6}, {1, 2, 5.0}, {1, 3, 1.02}}, {1.0, 1.0, 1.0, 0.0}, 0.5) == Flags{1, 1, 0});
  // A line without junctions stays, and so do cycles.
  CHECK(kept(2, {{0, 1, 0.1}}, {1.0, 1.0}, 9.0) == Flags{1});
  CHECK(kept(2, {{0, 0, 6.0}, {0, 1, 1.1}}, {1.0, 0.0}, 0.5) == Flags{1, 0});

  Rng rng(72);
  for (std::uint64_t round = 0; round < 200 * effort(); ++round) {
    const RandomGraph graph = random_graph(rng, 3 + rng.below(20), rng.below(3));
    const PathGraph whole(graph.nodes, graph.edges);
    std::vector<double> balls(graph.nodes);
    for (double& radius : balls) radius = rng.uniform(0.1, 1.0);
    const double limit = rng.uniform(0.0, 3.0);
    const Flags flags = salient_branches(whole, balls, limit);
    const MergedBranches merged = merge_branches(whole, flags);
    // Each kept edge is in one chain, and lengths are sums.
    std::set<std::uint32_t> seen;
    for (std::size_t i = 0; i < merged.edges.size(); ++i) {
      double length = 0.0;
      CHECK(whole.tail(merged.chains[i].front()) == merged.edges[i].from);
      CHECK(whole.head(merged.chains[i].back()) == merged.edges[i].to);
      for (const PathStep step : merged.chains[i]) {
        CHECK(flags[step.edge] == 1);
        CHECK(seen.insert(step.edge).second);
        length += whole.length(step);
      }
      CHECK(merged.edges[i].length == Approx(length).epsilon(1e-12));
    }
    CHECK(seen.size() == static_cast<std::size_t>(std::ranges::count(flags, 1)));
    // Cycles stay: edges minus nodes that have any, plus the one shape, if anything is left.
    std::set<std::uint32_t> ends;
    for (const PathEdge& edge : merged.edges) ends.insert({edge.from, edge.to});
    const std::size_t cycles = graph.edges.size() + 1 - graph.nodes;
    if (!merged.edges.empty()) CHECK(merged.edges.size() + 1 - ends.size() == cycles);
    if (merged.edges.empty()) CHECK(cycles == 0);
    // Arms that are left reach the limit by themselves.
    const AxisPaths paths(PathGraph(graph.nodes, merged.edges));
    for (const PathEdge& edge : merged.edges) {
      const bool is_first = paths.is_free_end(edge.from);
      if (is_first == paths.is_free_end(edge.to)) continue;
      const double ball = balls[is_first ? edge.to : edge.from];
      // The free end may stand for pruned arms that reach farther than its ball.
      double reach = balls[is_first ? edge.from : edge.to];
      for (const PathEdge& other : graph.edges) reach += other.length;
      CHECK((edge.length + reach - ball) / ball >= limit * (1.0 - 1e-12));
    }
  }
}

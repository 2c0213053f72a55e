// SPDX-License-Identifier: GPL-3.0-or-later
// Pruning of random graphs against a plain oracle: leaves below the limit are taken away one by one, in any order.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/filters/axis_pruning.h"

using namespace mes;

namespace {

struct AxisGraph {
  std::size_t nodes = 0;
  struct Edge {
    std::size_t a = 0;
    std::size_t b = 0;
    int value = 0;
  };
  std::vector<Edge> edges;
};

/// A forest with some edges more, so that there are cycles, and hairs on all of it. Values are small whole numbers, of
/// which many are equal.
AxisGraph random_graph(Rng& rng) {
  AxisGraph out;
  out.nodes = 1 + rng.below(40);
  for (std::size_t i = 1; i < out.nodes; ++i)
    if (rng.below(6) != 0) out.edges.push_back({rng.below(i), i, 0});
  for (std::size_t more = rng.below(5); more > 0; --more) {
    const std::size_t a = rng.below(out.nodes);
    const std::size_t b = rng.below(out.nodes);
    const bool is_there = std::ranges::any_of(out.edges, [&](const AxisGraph::Edge& edge) {
      return (edge.a == a && edge.b == b) || (edge.a == b && edge.b == a);
    });
    if (a != b && !is_there) out.edges.push_back({a, b, 0});
  }
  for (std::size_t i = out.edges.size(); i > 1; --i) std::swap(out.edges[i - 1], out.edges[rng.below(i)]);
  const std::uint64_t values = 1 + rng.below(12);
  for (AxisGraph::Edge& edge : out.edges) edge.value = static_cast<int>(rng.below(values));
  return out;
}

std::vector<std::size_t> degrees(const AxisGraph& graph, const std::vector<bool>& is_kept) {
  std::vector<std::size_t> out(graph.nodes, 0);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!is_kept[e]) continue;
    ++out[graph.edges[e].a];
    ++out[graph.edges[e].b];
  }
  return out;
}

/// Takes leaf edges below the limit away until there is none, each time any of them.
std::vector<bool> pruned(const AxisGraph& graph, int limit, Rng& rng) {
  std::vector<bool> is_kept(graph.edges.size(), true);
  for (;;) {
    const auto degree = degrees(graph, is_kept);
    std::vector<std::size_t> leaves;
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
      if (is_kept[e] && graph.edges[e].value < limit &&
          (degree[graph.edges[e].a] == 1 || degree[graph.edges[e].b] == 1))
        leaves.push_back(e);
    if (leaves.empty()) return is_kept;
    is_kept[leaves[rng.below(leaves.size())]] = false;
  }
}

/// Components by flooding, of the nodes that are there.
std::size_t components(const AxisGraph& graph, const std::vector<bool>& is_kept, const std::vector<bool>& has_node) {
  std::vector<std::size_t> name(graph.nodes);
  std::iota(name.begin(), name.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      if (!is_kept[e]) continue;
      std::size_t& a = name[graph.edges[e].a];
      std::size_t& b = name[graph.edges[e].b];
      if (a == b) continue;
      a = b = std::min(a, b);
      changed = true;
    }
  }
  std::size_t out = 0;
  for (std::size_t node = 0; node < graph.nodes; ++node) out += has_node[node] && name[node] == node ? 1U : 0U;
  if (std::ranges::all_of(has_node, [](bool is_there) { return is_there; })) return out;
  // A component is counted at its least node, whether that one is there or not.
  out = 0;
  std::vector<bool> is_counted(graph.nodes, false);
  for (std::size_t node = 0; node < graph.nodes; ++node) {
    if (!has_node[node] || is_counted[name[node]]) continue;
    is_counted[name[node]] = true;
    ++out;
  }
  return out;
}

/// In ascending order of the values; ties as they come.
AxisPruning prune(const AxisGraph& graph) {
  std::vector<std::size_t> order(graph.edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t e) { return graph.edges[e].value; });
  AxisPruning out;
  out.begin(graph.edges.size(), graph.nodes);
  for (const std::size_t e : order) out.add(EdgeSlot(e), FaceSlot(graph.edges[e].a), FaceSlot(graph.edges[e].b));
  out.run([](FaceSlot a, FaceSlot b) { return a < b; });
  return out;
}

}  // namespace

TEST_CASE("for every limit, what is left is what remains when leaves below it are taken away in any order") {
  Rng rng(1);
  for (int round = 0; round < 3000; ++round) {
    const AxisGraph graph = random_graph(rng);
    const AxisPruning pruning = prune(graph);
    const std::vector<bool> all_edges(graph.edges.size(), true);
    const std::vector<bool> all_nodes(graph.nodes, true);
    const std::size_t whole = components(graph, all_edges, all_nodes);
    const std::size_t cycles = graph.edges.size() + whole - graph.nodes;
    for (int limit = -1; limit <= 13; ++limit) {
      INFO("round " << round << " limit " << limit);
      std::vector<bool> is_kept(graph.edges.size());
      for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const EdgeSlot level = pruning.level_of(EdgeSlot(e));
        is_kept[e] = level == kNoSlot || graph.edges[level.index()].value >= limit;
      }
      REQUIRE(is_kept == pruned(graph, limit, rng));
      // With the roots of what has vanished, and nodes that never had an edge.
      const auto degree = degrees(graph, is_kept);
      std::vector<bool> has_node(graph.nodes);
      std::size_t nodes = 0;
      std::size_t edges = 0;
      for (std::size_t node = 0; node < graph.nodes; ++node) {
        has_node[node] = degree[node] != 0 || pruning.is_root(FaceSlot(node)) || pruning.degree(FaceSlot(node)) == 0;
        nodes += has_node[node] ? 1U : 0U;
      }
      for (const bool kept : is_kept) edges += kept ? 1U : 0U;
      const std::size_t left = components(graph, is_kept, has_node);
      REQUIRE(left == whole);
      REQUIRE(edges + left - nodes == cycles);
    }
  }
}

TEST_CASE("a tree has one root, a component with a cycle none, and a root is an end of the edge that goes last") {
  Rng rng(2);
  for (int round = 0; round < 500; ++round) {
    const AxisGraph graph = random_graph(rng);
    const AxisPruning pruning = prune(graph);
    std::vector<std::size_t> name(graph.nodes);
    std::iota(name.begin(), name.end(), std::size_t{0});
    for (std::size_t pass = 0; pass < graph.nodes; ++pass)
      for (const AxisGraph::Edge& edge : graph.edges)
        name[edge.a] = name[edge.b] = std::min(name[edge.a], name[edge.b]);
    for (std::size_t component = 0; component < graph.nodes; ++component) {
      std::size_t nodes = 0;
      std::size_t edges = 0;
      std::size_t roots = 0;
      for (std::size_t node = 0; node < graph.nodes; ++node) {
        if (name[node] != component) continue;
        ++nodes;
        roots += pruning.is_root(FaceSlot(node)) ? 1U : 0U;
      }
      int highest = -1;
      for (const AxisGraph::Edge& edge : graph.edges) edges += name[edge.a] == component ? 1U : 0U;
      for (const AxisGraph::Edge& edge : graph.edges)
        if (name[edge.a] == component) highest = std::max(highest, edge.value);
      if (edges == 0) continue;
      CHECK(roots == (edges + 1 == nodes ? 1U : 0U));
      for (std::size_t node = 0; node < graph.nodes; ++node) {
        if (name[node] != component || !pruning.is_root(FaceSlot(node))) continue;
        // The level of an edge there is the highest of the tree: nothing goes after it.
        int level = -1;
        for (std::size_t e = 0; e < graph.edges.size(); ++e)
          if (graph.edges[e].a == node || graph.edges[e].b == node)
            level = std::max(level, graph.edges[pruning.level_of(EdgeSlot(e)).index()].value);
        int top = -1;
        for (std::size_t e = 0; e < graph.edges.size(); ++e)
          if (name[graph.edges[e].a] == component)
            top = std::max(top, graph.edges[pruning.level_of(EdgeSlot(e)).index()].value);
        CHECK(level == top);
        CHECK(top <= highest);
      }
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/rng.h"
#include "core/structures/crust/internal/link_cut_forest.h"
#include "core/structures/delaunay/delaunay.h"

using namespace mes;

TEST_CASE("trees that are linked and cut at random answer as a search of them does") {
  Rng rng(17);
  constexpr std::uint32_t kVertices = 40;
  LinkCutForest<EdgeSlot, std::less<>> forest({});
  forest.clear(kVertices, kVertices);
  std::map<EdgeSlot, std::pair<std::uint32_t, std::uint32_t>> edges;
  // Returns the best edge of the way; nothing if there is no way.
  const std::function<std::optional<EdgeSlot>(std::uint32_t, std::uint32_t, EdgeSlot)> search =
      [&](std::uint32_t at, std::uint32_t to, EdgeSlot from) -> std::optional<EdgeSlot> {
    if (at == to) return EdgeSlot();  // after all others
    for (const auto& [edge, ends] : edges) {
      if (edge == from || (ends.first != at && ends.second != at)) continue;
      const auto rest = search(ends.first == at ? ends.second : ends.first, to, edge);
      if (rest) return std::min(edge, *rest);
    }
    return std::nullopt;
  };
  // Counts the marked edges of the way.
  std::set<EdgeSlot> marked;
  const std::function<std::optional<std::size_t>(std::uint32_t, std::uint32_t, EdgeSlot)> count =
      [&](std::uint32_t at, std::uint32_t to, EdgeSlot from) -> std::optional<std::size_t> {
    if (at == to) return 0;
    for (const auto& [edge, ends] : edges) {
      if (edge == from || (ends.first != at && ends.second != at)) continue;
      const auto rest = count(ends.first == at ? ends.second : ends.first, to, edge);
      if (rest) return *rest + (marked.contains(edge) ? 1U : 0U);
    }
    return std::nullopt;
  };
  int answers = 0;
  for (int step = 0; step < 4000; ++step) {
    const auto a = static_cast<std::uint32_t>(rng.below(kVertices));
    const auto b = static_cast<std::uint32_t>(rng.below(kVertices));
    const EdgeSlot edge(rng.below(kVertices));
    const auto way = search(a, b, kNoSlot);
    REQUIRE(forest.are_connected(a, b) == way.has_value());
    if (a != b && way) {
      REQUIRE(forest.best_between(a, b) == *way);
      REQUIRE(forest.are_marks_odd(a, b) == (*count(a, b, kNoSlot) % 2 == 1));
      ++answers;
    }
    if (step % 5 == 0 && edges.contains(edge)) {
      const bool is_marked = !marked.contains(edge);
      forest.set_mark(edge, is_marked);
      if (is_marked)
        marked.insert(edge);
      else
        marked.erase(edge);
    }
    if (const auto found = edges.find(edge); found != edges.end() && step % 3 == 0) {
      forest.cut(edge, found->second.first, found->second.second);
      edges.erase(found);
      marked.erase(edge);
    } else if (found == edges.end() && !way) {
      forest.link(edge, a, b);
      edges[edge] = {a, b};
    }
  }
  CHECK(answers > 500);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Labels against two other ways to them: where the curve is closed, counting curve edges between a Voronoi vertex and
// far away; where it is not, the rule of core/structures/internal/conflict_join.h in its plainest form, one spanning
// tree of the whole triangulation by exact comparisons.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numeric>

#include "core/base/rng.h"
#include "core/structures/labels.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"
#include "tests/support/shapes_benchmark.h"
#include "tests/support/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct Input {
  std::string name;
  std::vector<Vec2> positions;
};

std::vector<Vec2> grid_draws(std::size_t n, std::uint64_t size, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back({static_cast<double>(rng.below(size)), static_cast<double>(rng.below(size))});
  return out;
}

std::vector<Input> inputs() {
  std::vector<Input> out;
  for (const TestShape& shape : oracle_shapes(0.45, {0.3, 0.2, 7})) out.push_back({shape.name, shape.data.positions});
  for (DegenerateInput& input : degenerate_inputs()) out.push_back({input.name, std::move(input.positions)});
  for (const std::size_t n : {220U, 300U}) out.push_back({"smooth curve", benchmark_curve(n)});
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    out.push_back({"smooth curve", benchmark_curve(160, seed)});
    out.push_back({"rough curve", rough_curve(160, seed)});
    out.push_back({"noisy curve", noisy_curve(120, seed)});
    out.push_back({"square", uniform_square(100, seed)});
    out.push_back({"duplicates", duplicate_heavy(200, seed)});
    out.push_back({"large grid", grid_draws(80, 1U << 20U, 20 + seed)});
  }
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    out.push_back({"few of a small grid", grid_draws(5 + seed % 20, 6, 100 + seed)});
  return out;
}

// All sites as integers of one scale.
std::vector<ExactPoint> exact_sites(const Delaunay& delaunay) {
  std::vector<Vec2> positions = delaunay.site_positions();
  for (Slot site = 0; site < delaunay.site_rows(); ++site)
    if (!delaunay.is_site(site)) positions[site] = Vec2{};
  return as_integers(positions);
}

// A point with the common denominator `w` > 0.
struct Homogeneous {
  mpz_class x, y, w;
};

Homogeneous circumcenter(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const ExactPoint u = b - a;
  const ExactPoint v = c - a;
  const mpz_class uu = dot(u, u);
  const mpz_class vv = dot(v, v);
  const mpz_class w = 2 * cross(u, v);  // positive: counter-clockwise
  return {a.x * w + v.y * uu - u.y * vv, a.y * w + u.x * vv - v.x * uu, w};
}

enum class Place { inside, outside, on_the_curve };

// Even-odd along the horizontal ray to the right.
Place place_of(const Homogeneous& c, const std::vector<std::pair<ExactPoint, ExactPoint>>& curve) {
  bool inside = false;
  for (const auto& [a, b] : curve) {
    const bool a_above = a.y * c.w > c.y;
    const bool b_above = b.y * c.w > c.y;
    // Side of the edge, upwards: positive = the point lies left of it.
    const mpz_class side = (b.x - a.x) * (c.y - a.y * c.w) - (b.y - a.y) * (c.x - a.x * c.w);
    if (side == 0 && std::min(a.x, b.x) * c.w <= c.x && c.x <= std::max(a.x, b.x) * c.w &&
        std::min(a.y, b.y) * c.w <= c.y && c.y <= std::max(a.y, b.y) * c.w)
      return Place::on_the_curve;
    if (a_above == b_above) continue;
    if ((b_above && side > 0) || (a_above && side < 0)) inside = !inside;
  }
  return inside ? Place::inside : Place::outside;
}

struct RankedEdge {
  Slot edge;
  bool mends;
  mpz_class squared_length;
  ExactCot certainty;
  Vec2 low, high;
};

// Conflicts by the rule: Kruskal over all edges in its total order, then the tree edges that separate an odd number
// of odd sites from the rest.
std::set<PlaceEdge> conflicts_by_rule(const Workbench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  std::vector<int> degree(delaunay.site_rows(), 0);
  for (Slot edge = 0; edge < delaunay.edge_rows(); ++edge)
    if (delaunay.edge(edge).is_alive() && crust.is_crust(edge))
      for (const Slot site : delaunay.edge(edge).v) ++degree[site];
  const auto is_odd = [&](Slot site) { return degree[site] % 2 == 1; };
  const std::vector<ExactPoint> exact = exact_sites(delaunay);

  std::vector<RankedEdge> edges;
  for (Slot edge = 0; edge < delaunay.edge_rows(); ++edge) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive()) continue;
    RankedEdge ranked{edge, false, {}, exact_edge(crust.corners(edge)).certainty(), {}, {}};
    const int a = degree[row.v[0]];
    const int b = degree[row.v[1]];
    if (is_odd(row.v[0]) && is_odd(row.v[1]))
      ranked.mends = crust.is_crust(edge) ? a >= 3 && b >= 3 : a == 1 && b == 1;
    const ExactPoint along = exact[row.v[1]] - exact[row.v[0]];
    ranked.squared_length = dot(along, along);
    ranked.low = delaunay.site_position(row.v[0]);
    ranked.high = delaunay.site_position(row.v[1]);
    if (lexicographically_less(ranked.high, ranked.low)) std::swap(ranked.low, ranked.high);
    edges.push_back(std::move(ranked));
  }
  std::ranges::sort(edges, [](const RankedEdge& a, const RankedEdge& b) {
    if (a.mends != b.mends) return a.mends;
    const int order = a.mends ? cmp(a.squared_length, b.squared_length) : compare(a.certainty, b.certainty);
    if (order != 0) return order < 0;
    if (a.low != b.low) return lexicographically_less(a.low, b.low);
    return lexicographically_less(a.high, b.high);
  });

  std::vector<Slot> parent(delaunay.site_rows());
  std::iota(parent.begin(), parent.end(), Slot{0});
  const auto root = [&parent](Slot site) {
    while (parent[site] != site) site = parent[site];
    return site;
  };
  std::vector<std::vector<std::pair<Slot, Slot>>> tree(delaunay.site_rows());
  for (const RankedEdge& ranked : edges) {
    const Slot a = delaunay.edge(ranked.edge).v[0];
    const Slot b = delaunay.edge(ranked.edge).v[1];
    if (root(a) == root(b)) continue;
    parent[root(a)] = root(b);
    tree[a].push_back({b, ranked.edge});
    tree[b].push_back({a, ranked.edge});
  }
  std::set<PlaceEdge> conflicts;
  // Odd sites below each tree edge, from any site on; the whole has an even number.
  std::vector<std::array<Slot, 3>> visits;  // site, site it was reached from, edge
  for (Slot site = 0; site < delaunay.site_rows() && visits.empty(); ++site)
    if (delaunay.is_site(site)) visits.push_back({site, kNoSlot, kNoSlot});
  for (std::size_t next = 0; next < visits.size(); ++next)
    for (const auto& [other, edge] : tree[visits[next][0]])
      if (other != visits[next][1]) visits.push_back({other, visits[next][0], edge});
  std::vector<int> below(delaunay.site_rows(), 0);
  for (std::size_t i = visits.size(); i-- > 1;) {
    const auto [site, from, edge] = visits[i];
    below[site] += is_odd(site) ? 1 : 0;
    below[from] += below[site];
    if (below[site] % 2 == 1)
      conflicts.insert(place_edge(delaunay.site_position(delaunay.edge(edge).v[0]),
                                  delaunay.site_position(delaunay.edge(edge).v[1])));
  }
  return conflicts;
}

std::set<PlaceEdge> conflicts_of(const Workbench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& labels = bench.get<Labels>();
  std::set<PlaceEdge> out;
  for (Slot edge = 0; edge < delaunay.edge_rows(); ++edge) {
    const EdgeRow& row = delaunay.edge(edge);
    if (row.is_alive() && labels.is_conflict(edge))
      out.insert(place_edge(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1])));
  }
  return out;
}

}  // namespace

TEST_CASE("without odd samples a face is inside exactly if its circumcentre is inside the curve") {
  int closed_inputs = 0;
  int inside_faces = 0;
  for (const Input& input : inputs()) {
    INFO(input.name);
    const Workbench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& crust = bench.get<OneStepCrust>();
    const auto& labels = bench.get<Labels>();
    if (crust.odd_count() != 0 || delaunay.dimension() < 2) continue;
    ++closed_inputs;
    CHECK(labels.conflict_count() == 0);
    // Outside at infinity and right across every edge: there is only one such labelling.
    CHECK(broken_row(bench.graph()) == "");
    const std::vector<ExactPoint> exact = exact_sites(delaunay);
    std::vector<std::pair<ExactPoint, ExactPoint>> curve;
    for (Slot edge = 0; edge < delaunay.edge_rows(); ++edge) {
      const EdgeRow& row = delaunay.edge(edge);
      if (row.is_alive() && crust.is_crust(edge)) curve.emplace_back(exact[row.v[0]], exact[row.v[1]]);
    }
    for (Slot face = 0; face < delaunay.face_rows(); ++face) {
      if (!delaunay.is_finite_face(face)) continue;
      const FaceRow& row = delaunay.face(face);
      const Place place = place_of(circumcenter(exact[row.v[0]], exact[row.v[1]], exact[row.v[2]]), curve);
      inside_faces += place == Place::inside ? 1 : 0;
      // A right triangle on the hull has its circumcentre on the curve, and counts as inside.
      if (labels.is_inside(face) != (place != Place::outside)) FAIL("a label is not the parity at the circumcentre");
    }
  }
  CHECK(closed_inputs > 40);
  CHECK(inside_faces > 1500);
}

TEST_CASE("with odd samples the conflicts are those of the canonical rule") {
  int with_conflicts = 0;
  for (const Input& input : inputs()) {
    const Workbench bench(input.positions);
    if (bench.get<Delaunay>().dimension() < 2) continue;
    INFO(input.name << ", " << bench.get<OneStepCrust>().odd_count() << " odd");
    const std::set<PlaceEdge> conflicts = conflicts_of(bench);
    CHECK(conflicts == conflicts_by_rule(bench));
    CHECK(conflicts.empty() == (bench.get<OneStepCrust>().odd_count() == 0));
    CHECK(broken_row(bench.graph()) == "");
    with_conflicts += conflicts.empty() ? 0 : 1;
  }
  CHECK(with_conflicts > 100);
}

TEST_CASE("the rule also holds after edits, one after the other") {
  Rng rng(3);
  for (const bool lattice : {false, true}) {
    Workbench bench(lattice ? grid_draws(40, 7, 1) : noisy_curve(90));
    for (int step = 0; step < 120; ++step) {
      const std::vector<SampleId> ids = bench.ids();
      const SampleId id = ids[rng.below(ids.size())];
      const Vec2 p = bench.document().position(bench.document().slot_of(id));
      const Vec2 near = lattice ? Vec2{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))}
                                : p + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)};
      const std::uint64_t action = rng.below(4);
      if (action == 0) {
        bench.insert({near});
      } else if (action == 1 && ids.size() > 20) {
        bench.remove({id});
      } else {
        bench.move(id, near);
      }
      INFO("step " << step);
      REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Labels against two other ways to them: where the curve is closed, counting curve edges between a Voronoi vertex and
// far away; where it is not, the rule of core/structures/crust/internal/open_strokes.h and conflict_join.h in its
// plainest form, one spanning tree of the whole triangulation by exact comparisons.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <optional>

#include "core/base/rng.h"
#include "core/structures/crust/internal/conflict_join.h"
#include "core/structures/crust/labels.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/grid_draws.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct LabelInput {
  std::string name;
  std::vector<Vec2> positions;
};

// Each has eight samples, and those of neighbours that are nearest to each other are odd.
std::vector<Vec2> lattice_of_circles() {
  std::vector<Vec2> out;
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 10; ++column)
      for (int i = 0; i < 8; ++i) {
        const double angle = i * 0.78539816339744831;
        out.push_back({10.0 * column + 3.0 * std::cos(angle), 10.0 * row + 3.0 * std::sin(angle)});
      }
  return out;
}

// Lengths of one and of eight, so that many an edge is as long as a long one may just not be.
Vec2 pair_place(Rng& rng) {
  const auto side = [&rng] { return static_cast<double>(8 * rng.below(6) + rng.below(2)); };
  const double x = side();
  return {x, side()};
}

std::vector<Vec2> pairs_eight_apart(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i) out.push_back(pair_place(rng));
  return out;
}

// Samples some 8 apart along a curve, up to `jitter` off it either way.
template <class Curve>
std::vector<Vec2> stroke(Curve at, double end, double jitter, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (double t = 0.0; t <= end;) {
    const Vec2 p = at(t);
    out.push_back(p + Vec2{rng.uniform(-jitter, jitter), rng.uniform(-jitter, jitter)});
    t += rng.uniform(6.4, 9.6) * 1e-4 / distance(p, at(t + 1e-4));
  }
  return out;
}

Vec2 wave(double t) {
  return {100.0 * t, 100.0 * std::sin(t)};
}

Vec2 flat_wave(double t) {
  return {100.0 * t, 25.0 * std::sin(t)};
}

Vec2 spiral(double t) {
  return {(40.0 + 25.0 * t) * std::cos(t), (40.0 + 25.0 * t) * std::sin(t)};
}

Vec2 circle(double t) {
  return {200.0 * std::cos(t), 200.0 * std::sin(t)};
}

std::vector<Vec2> both(std::vector<Vec2> a, const std::vector<Vec2>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// What a hand sprays: no stroke of it closes anything.
std::vector<LabelInput> open_strokes() {
  return {
      {"wave", stroke(wave, 19.0, 0.0, 1)},
      {"flat wave", stroke(flat_wave, 19.0, 0.5, 1)},
      {"few samples", stroke(wave, 1.0, 2.0, 1)},
      {"one arch and a bit", stroke(wave, 5.5, 0.5, 2)},
      {"spiral", stroke(spiral, 12.6, 0.5, 3)},
      {"longer spiral", stroke(spiral, 18.8, 0.0, 4)},
      {"jittery wave", stroke(wave, 15.7, 2.4, 5)},
      {"jittery spiral", stroke(spiral, 15.7, 2.4, 6)},
      {"dashed wave", both(stroke(wave, 6.0, 0.5, 7), stroke([](double t) { return wave(t + 6.5); }, 6.0, 0.5, 8))}};
}

std::vector<LabelInput> inputs() {
  std::vector<LabelInput> out;
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
  for (LabelInput& input : open_strokes()) out.push_back(std::move(input));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    out.push_back({"rough wave", stroke(wave, 15.7, 4.0, seed)});
    out.push_back({"rough spiral", stroke(spiral, 15.7, 4.0, seed)});
    out.push_back(
        {"circle with a gap and dirt in it", both(stroke(circle, 5.8, 0.5, seed), {{185, -40}, {170, -70}})});
    out.push_back({"stroke in a circle", both(stroke(circle, 6.26, 0.0, seed), stroke(flat_wave, 1.2, 0.5, seed))});
  }
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    out.push_back({"pairs eight apart", pairs_eight_apart(10 + 2 * seed, seed)});
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    out.push_back({"few of a small grid", grid_draws(5 + seed % 20, 6, 100 + seed)});
  return out;
}

// All sites as integers of one scale.
Table<SiteSlot, ExactPoint> exact_sites(const Delaunay& delaunay) {
  Table<SiteSlot, Vec2> positions = delaunay.site_positions();
  for (const SiteSlot site : delaunay.site_slots())
    if (!delaunay.is_site(site)) positions[site] = Vec2{};
  Table<SiteSlot, ExactPoint> out;
  out.values() = as_integers(positions.values());
  return out;
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
  EdgeSlot edge;
  int kind;  // 0 mends, 2 comes last, 1 is any other
  mpz_class squared_length;
  ExactCot certainty;
  Vec2 low, high;
};

// Where an odd site finds a partner: the first component of Kruskal's algorithm around it with an even number of
// odd sites.
struct Partner {
  SiteSlot site;
  std::size_t component;
};

// The other end and the edge, by site.
using Tree = Table<SiteSlot, std::vector<std::pair<SiteSlot, EdgeSlot>>>;
// By depth first search.
std::vector<EdgeSlot> way_in_tree(const Tree& tree, SiteSlot a, SiteSlot b) {
  std::vector<EdgeSlot> way;
  const std::function<bool(SiteSlot, SiteSlot)> reaches = [&](SiteSlot site, SiteSlot from) {
    if (site == b) return true;
    for (const auto& [other, edge] : tree[site]) {
      if (other == from) continue;
      way.push_back(edge);
      if (reaches(other, site)) return true;
      way.pop_back();
    }
    return false;
  };
  reaches(a, kNoSlot);
  return way;
}

// The edges of the connected part of the curve that holds both sites, if it is a path from one to the other: a
// connected graph with two sites of degree one and all others of degree two.
std::vector<EdgeSlot> open_stroke(const Delaunay& delaunay, const std::set<EdgeSlot>& curve, SiteSlot a, SiteSlot b) {
  std::map<SiteSlot, std::vector<std::pair<SiteSlot, EdgeSlot>>> at;
  for (const EdgeSlot edge : curve) {
    const SiteSlot* v = delaunay.edge(edge).v;
    at[v[0]].push_back({v[1], edge});
    at[v[1]].push_back({v[0], edge});
  }
  std::set<SiteSlot> part{a};
  std::set<EdgeSlot> edges;
  std::vector<SiteSlot> todo{a};
  while (!todo.empty()) {
    const SiteSlot site = todo.back();
    todo.pop_back();
    if (at[site].size() != (site == a || site == b ? 1U : 2U)) return {};
    for (const auto& [other, edge] : at[site]) {
      edges.insert(edge);
      if (part.insert(other).second) todo.push_back(other);
    }
  }
  if (!part.contains(b)) return {};
  return {edges.begin(), edges.end()};
}

// All edges, the most doubtful first, by exact arithmetic.
std::vector<RankedEdge> edges_in_order(const Delaunay& delaunay, const OneStepCrust& crust,
                                       const Table<SiteSlot, int>& degree) {
  const Table<SiteSlot, ExactPoint> exact = exact_sites(delaunay);
  const auto square = [&](EdgeSlot edge) {
    const ExactPoint along = exact[delaunay.edge(edge).v[1]] - exact[delaunay.edge(edge).v[0]];
    return mpz_class(dot(along, along));
  };
  Table<SiteSlot, mpz_class> longest(delaunay.site_rows(), 0);
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive() && crust.is_crust(edge))
      for (const SiteSlot site : delaunay.edge(edge).v) longest[site] = std::max(longest[site], square(edge));
  std::vector<RankedEdge> edges;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive()) continue;
    RankedEdge ranked{edge, 1, square(edge), exact_edge(crust.corners(edge)).certainty(), {}, {}};
    const bool is_cocircular = exact_edge(crust.corners(edge)).is_cocircular();
    const bool is_long = ranked.squared_length > 64 * std::max(longest[row.v[0]], longest[row.v[1]]);
    if (!crust.is_crust(edge) && (is_cocircular || is_long)) ranked.kind = 2;
    const int a = degree[row.v[0]];
    const int b = degree[row.v[1]];
    // A diagonal of cocircular sites mends nothing: another triangulation has another one.
    if (a % 2 == 1 && b % 2 == 1 && !is_cocircular && (crust.is_crust(edge) ? a >= 3 && b >= 3 : a == 1 && b == 1))
      if (crust.is_crust(edge) || !is_long) ranked.kind = 0;
    ranked.low = delaunay.site_position(row.v[0]);
    ranked.high = delaunay.site_position(row.v[1]);
    if (lexicographically_less(ranked.high, ranked.low)) std::swap(ranked.low, ranked.high);
    edges.push_back(std::move(ranked));
  }
  std::ranges::sort(edges, [](const RankedEdge& a, const RankedEdge& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    const int order = a.kind == 0 ? cmp(a.squared_length, b.squared_length) : compare(a.certainty, b.certainty);
    if (order != 0) return order < 0;
    if (a.low != b.low) return lexicographically_less(a.low, b.low);
    return lexicographically_less(a.high, b.high);
  });
  return edges;
}

// The edges of a matching of odd sites: of those that repair two, the most doubtful first, as long as both are free.
// What is matched is not odd any more.
std::set<EdgeSlot> repaired_edges(const Delaunay& delaunay, const OneStepCrust& crust,
                                  const std::vector<RankedEdge>& edges, const Table<SiteSlot, int>& degree,
                                  Table<SiteSlot, bool>& is_odd) {
  std::set<EdgeSlot> out;
  for (const RankedEdge& ranked : edges) {
    const SiteSlot* end = delaunay.edge(ranked.edge).v;
    if (!is_odd[end[0]] || !is_odd[end[1]]) continue;
    const bool is_spur = crust.is_crust(ranked.edge) && (degree[end[0]] == 1 || degree[end[1]] == 1);
    if (ranked.kind != 0 && !is_spur) continue;
    is_odd[end[0]] = is_odd[end[1]] = false;
    out.insert(ranked.edge);
  }
  return out;
}

// Kruskal over all edges.
Table<SiteSlot, Partner> partners(const Delaunay& delaunay, const std::vector<RankedEdge>& edges,
                                  const Table<SiteSlot, bool>& is_odd, Tree& tree) {
  Table<SiteSlot, std::vector<SiteSlot>> members(delaunay.site_rows());
  Table<SiteSlot, SiteSlot> component(delaunay.site_rows());
  Table<SiteSlot, std::optional<SiteSlot>> left_over(delaunay.site_rows());
  Table<SiteSlot, Partner> out(delaunay.site_rows(), {kNoSlot, 0});
  for (const SiteSlot site : delaunay.site_slots()) {
    members[site] = {site};
    component[site] = site;
    if (is_odd[site]) left_over[site] = site;
  }
  for (const RankedEdge& ranked : edges) {
    const SiteSlot a = delaunay.edge(ranked.edge).v[0];
    const SiteSlot b = delaunay.edge(ranked.edge).v[1];
    const SiteSlot kept = component[a];
    const SiteSlot gone = component[b];
    if (kept == gone) continue;
    tree[a].push_back({b, ranked.edge});
    tree[b].push_back({a, ranked.edge});
    for (const SiteSlot site : members[gone]) component[site] = kept;
    members[kept].insert(members[kept].end(), members[gone].begin(), members[gone].end());
    if (left_over[kept] && left_over[gone]) {
      out[*left_over[kept]] = {*left_over[gone], members[kept].size()};
      out[*left_over[gone]] = {*left_over[kept], members[kept].size()};
      left_over[kept].reset();
    } else if (left_over[gone]) {
      left_over[kept] = left_over[gone];
    }
  }
  return out;
}

// Conflicts by the rule: the edges of open strokes, and the join of the other odd sites in the tree.
std::set<PlaceEdge> conflicts_by_rule(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  std::set<EdgeSlot> curve;
  Table<SiteSlot, int> degree(delaunay.site_rows(), 0);
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || !crust.is_crust(edge)) continue;
    curve.insert(edge);
    for (const SiteSlot site : delaunay.edge(edge).v) ++degree[site];
  }
  Table<SiteSlot, bool> is_odd(delaunay.site_rows(), false);
  std::vector<SiteSlot> to_join;
  for (const SiteSlot site : delaunay.site_slots()) {
    is_odd[site] = degree[site] % 2 == 1;
    if (is_odd[site]) to_join.push_back(site);
  }
  const auto toggle = [](std::set<EdgeSlot>& set, EdgeSlot edge) {
    if (set.erase(edge) == 0) set.insert(edge);
  };
  const std::vector<RankedEdge> edges = edges_in_order(delaunay, crust, degree);
  for (const EdgeSlot edge : repaired_edges(delaunay, crust, edges, degree, is_odd)) toggle(curve, edge);
  Tree tree(delaunay.site_rows());
  const Table<SiteSlot, Partner> partner = partners(delaunay, edges, is_odd, tree);
  const Table<SiteSlot, ExactPoint> exact = exact_sites(delaunay);
  const auto square = [&exact](SiteSlot from, SiteSlot to) {
    return mpz_class(dot(exact[to] - exact[from], exact[to] - exact[from]));
  };

  std::set<EdgeSlot> conflicts;
  for (const SiteSlot a : delaunay.site_slots()) {
    for (const SiteSlot b : slots_between<SiteSlot>(a.index() + std::size_t{1}, delaunay.site_rows())) {
      if (!is_odd[a] || !is_odd[b] || degree[a] != 1 || degree[b] != 1) continue;
      const std::vector<EdgeSlot> chain = open_stroke(delaunay, curve, a, b);
      if (chain.empty()) continue;
      // A gap that is not wide.
      mpz_class longest = 0;
      for (const EdgeSlot edge : chain)
        longest = std::max(longest, square(delaunay.edge(edge).v[0], delaunay.edge(edge).v[1]));
      if (square(a, b) <= 16 * longest) continue;
      const std::size_t reach = 128 + (chain.size() + 1) / 16;
      const auto finds = [&](SiteSlot site) { return partner[site].component <= reach; };
      const bool each_other =
          partner[a].site == b && way_in_tree(tree, a, b).size() > 2 && chain.size() + 1 < 16 * partner[a].component;
      if ((finds(a) || finds(b)) && !(finds(a) && finds(b) && each_other)) continue;
      conflicts.insert(chain.begin(), chain.end());
      std::erase(to_join, a);
      std::erase(to_join, b);
    }
  }
  // Whichever two are taken together, the join is the same.
  for (std::size_t i = 0; i + 1 < to_join.size(); i += 2)
    for (const EdgeSlot edge : way_in_tree(tree, to_join[i], to_join[i + 1])) toggle(conflicts, edge);
  std::set<PlaceEdge> out;
  for (const EdgeSlot edge : conflicts)
    out.insert(place_edge(delaunay.site_position(delaunay.edge(edge).v[0]),
                          delaunay.site_position(delaunay.edge(edge).v[1])));
  return out;
}

std::set<PlaceEdge> conflicts_of(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& labels = bench.get<Labels>();
  std::set<PlaceEdge> out;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
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
  for (const LabelInput& input : inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& crust = bench.get<OneStepCrust>();
    const auto& labels = bench.get<Labels>();
    if (crust.odd_count() != 0 || delaunay.dimension() < 2) continue;
    ++closed_inputs;
    CHECK(labels.conflict_count() == 0);
    // Outside at infinity and right across every edge: there is only one such labelling.
    CHECK(broken_row(bench.graph()) == "");
    const Table<SiteSlot, ExactPoint> exact = exact_sites(delaunay);
    std::vector<std::pair<ExactPoint, ExactPoint>> curve;
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      const EdgeRow& row = delaunay.edge(edge);
      if (row.is_alive() && crust.is_crust(edge)) curve.emplace_back(exact[row.v[0]], exact[row.v[1]]);
    }
    for (const FaceSlot face : delaunay.face_slots()) {
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
  for (const LabelInput& input : inputs()) {
    const ComparedBench bench(input.positions);
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

TEST_CASE("an open stroke has no inside") {
  for (const LabelInput& input : open_strokes()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const auto& delaunay = bench.get<Delaunay>();
    CHECK(bench.get<OneStepCrust>().odd_count() >= 2);
    int inside = 0;
    for (const FaceSlot face : delaunay.face_slots())
      if (delaunay.is_finite_face(face) && bench.get<Labels>().is_inside(face)) ++inside;
    CHECK(inside == 0);
  }
}

TEST_CASE("beside an open stroke a closed curve keeps its inside, and a gap is closed") {
  const auto inside = [](const std::vector<Vec2>& positions) {
    const ComparedBench bench(positions);
    const auto& delaunay = bench.get<Delaunay>();
    std::set<Vec2, bool (*)(Vec2, Vec2)> out(lexicographically_less);
    for (const FaceSlot face : delaunay.face_slots())
      if (delaunay.is_finite_face(face) && bench.get<Labels>().is_inside(face))
        out.insert(delaunay.circumcenter(face));
    return out;
  };
  const auto is_in_circle = [](Vec2 p) { return length(p) < 200.0; };
  const auto beside = inside(both(stroke(circle, 6.26, 0.0, 1), stroke(
                                                                    [](double t) {
                                                                      return wave(t) + Vec2{350, 0};
                                                                    },
                                                                    12.0, 0.5, 1)));
  CHECK(beside.size() > 100);
  CHECK(std::ranges::all_of(beside, is_in_circle));
  const auto with_gap = inside(both(stroke(circle, 5.8, 0.5, 1), {{185, -40}, {170, -70}}));
  CHECK(with_gap.size() > 100);
}

TEST_CASE("the rule also holds after edits, one after the other") {
  Rng rng(3);
  const std::vector<LabelInput> starts = {
      {"noise", noisy_curve(90)},
      {"lattice", grid_draws(40, 7, 1)},
      {"wave", stroke(wave, 9.0, 1.0, 1)},
      {"jittery wave", stroke(wave, 9.0, 2.8, 2)},
      {"spiral", stroke(spiral, 9.0, 1.5, 3)},
      {"pairs eight apart", pairs_eight_apart(50, 4)},
      {"stroke in a circle", both(stroke(circle, 6.26, 0.0, 1), stroke(flat_wave, 1.2, 0.5, 1))}};
  for (const LabelInput& start : starts) {
    const bool lattice = start.name == "lattice";
    const bool in_pairs = start.name == "pairs eight apart";
    ComparedBench bench(start.positions);
    for (int step = 0; step < 120; ++step) {
      const std::vector<SampleId> ids = bench.ids();
      const SampleId id = ids[rng.below(ids.size())];
      const Vec2 p = bench.document().position(bench.document().slot_of(id));
      const Vec2 near = in_pairs  ? pair_place(rng)
                        : lattice ? Vec2{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))}
                                  : p + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)};
      const std::uint64_t action = rng.below(4);
      if (action == 0) {
        bench.insert({near});
      } else if (action == 1 && ids.size() > 20) {
        bench.remove({id});
      } else {
        bench.move(id, near);
      }
      INFO(start.name << ", step " << step);
      REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
    }
  }
}

TEST_CASE("the rule holds where so many samples are odd that all labels follow from one tree") {
  Rng rng(11);
  ComparedBench bench;
  bench.show({"interior-voronoi-disks", "label-conflicts"});
  bench.replace(uniform_square(900, 5));
  // From this number on, `ConflictJoin` first tries a few clusters.
  CHECK(bench.get<OneStepCrust>().odd_count() > 64 + 900 / 3);
  const auto near = [&rng](Vec2 p) { return p + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)}; };
  for (int step = 0; step < 12; ++step) {
    INFO("step " << step);
    REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
    const std::vector<SampleId> ids = bench.ids();
    const SampleId id = ids[rng.below(ids.size())];
    const Vec2 p = bench.document().position(bench.document().slot_of(id));
    if (step % 4 == 1) {
      bench.insert({near(p)});
    } else if (step % 4 == 2) {
      bench.remove({id});
    } else {
      bench.move(id, near(p));
    }
  }
  // From noise to a curve and back: clusters take over from the tree, and the tree from them.
  for (const auto& positions : {stroke(circle, 6.2, 1.0, 1), uniform_square(400, 6)}) {
    std::vector<std::pair<SampleId, Vec2>> targets;
    const std::vector<SampleId> ids = bench.ids();
    for (std::size_t i = 0; i < positions.size(); ++i) targets.emplace_back(ids[i], positions[i]);
    bench.remove({ids.begin() + static_cast<std::ptrdiff_t>(positions.size()), ids.end()});
    REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
    bench.move(targets);
    REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
    if (positions.size() < 300) bench.insert(uniform_square(400 - positions.size(), 7));
  }
}

TEST_CASE("the rule holds in a lattice of circles, where half of the samples are odd and find partners beside them") {
  const std::vector<Vec2> positions = lattice_of_circles();
  ComparedBench bench(positions);
  // From this number on, `ConflictJoin` first tries a few clusters.
  CHECK(bench.get<OneStepCrust>().odd_count() > 64 + positions.size() / 3);
  Rng rng(12);
  for (int step = 0; step < 8; ++step) {
    INFO("step " << step);
    const std::set<PlaceEdge> conflicts = conflicts_of(bench);
    CHECK(conflicts.size() > 150);
    REQUIRE(conflicts == conflicts_by_rule(bench));
    const std::vector<SampleId> ids = bench.ids();
    const SampleId id = ids[rng.below(ids.size())];
    if (step % 3 == 0) {
      bench.remove({id});
    } else {
      bench.move(id, bench.document().position(bench.document().slot_of(id)) + Vec2{rng.uniform(-3.0, 3.0), 0.0});
    }
  }
  // To noise and back.
  std::vector<std::pair<SampleId, Vec2>> targets;
  const std::vector<SampleId> ids = bench.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) targets.emplace_back(ids[i], positions[i]);
  std::vector<std::pair<SampleId, Vec2>> noise = targets;
  for (auto& [id, at] : noise) at = {rng.uniform(0.0, 100.0), rng.uniform(0.0, 100.0)};
  for (const auto& moves : {noise, targets}) {
    bench.move(moves);
    REQUIRE(conflicts_of(bench) == conflicts_by_rule(bench));
  }
}

TEST_CASE("samples that mend with each other are joined without a look at other edges") {
  const ComparedBench bench(lattice_of_circles());
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  CHECK(crust.odd_count() == 360);
  JobControl job;
  CertaintyOrder order(delaunay, crust);
  OpenStrokes strokes(delaunay, crust, order);
  strokes.rebuild(job);
  ConflictJoin join(delaunay, crust, order, strokes);
  REQUIRE(join.rebuild(job));
  std::size_t joined = 0;
  for (const EdgeSlot edge : delaunay.edge_slots()) joined += join.has_edge(edge) ? 1U : 0U;
  CHECK(joined == 180);
  // An edge that is not crust has a key only if its length was compared with the crust beside it.
  CHECK_FALSE(order.keeps_lengths());
}

TEST_CASE("the tree of faces follows edits of noise one by one as it would be made anew") {
  for (const std::uint64_t seed : {1U, 2U}) {
    Rng rng(seed);
    ComparedBench bench;
    bench.show({"curve", "label-conflicts"});
    bench.replace(seed == 1 ? uniform_square(400, 8) : grid_draws(400, 24, 9));
    for (std::uint64_t step = 0; step < 150; ++step) {
      const std::vector<SampleId> ids = bench.ids();
      std::vector<std::pair<SampleId, Vec2>> targets;
      for (std::uint64_t k = rng.below(3) == 0 ? 3 : 1; k-- > 0;) {
        const SampleId id = ids[(step * 7 + k * 31) % ids.size()];
        const Vec2 p = bench.document().position(bench.document().slot_of(id));
        targets.emplace_back(id, seed == 1
                                     ? p + Vec2{rng.uniform(-20.0, 20.0), rng.uniform(-20.0, 20.0)}
                                     : Vec2{static_cast<double>(rng.below(24)), static_cast<double>(rng.below(24))});
      }
      bench.move(targets);
      INFO("seed " << seed << ", step " << step);
      ComparedBench fresh;
      fresh.show({"curve", "label-conflicts"});
      std::vector<Vec2> positions = bench.positions();
      std::ranges::reverse(positions);
      fresh.replace(positions);
      REQUIRE(conflicts_of(bench) == conflicts_of(fresh));
      REQUIRE(broken_row(bench.graph()) == "");
    }
  }
}

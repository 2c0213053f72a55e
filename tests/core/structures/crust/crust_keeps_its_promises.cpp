// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the one-step crust by proof: it is what its definition says, its edges are Gabriel edges that
// cross their duals, it does not depend on the order of insertion nor on similarities, and it contains the crust of
// Amenta, Bern and Eppstein.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "core/base/rng.h"
#include "core/structures/crust/one_step_crust.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/grid_draws.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct CrustInput {
  std::string name;
  std::vector<Vec2> positions;
};

// Integers below 2^20 in size, so that their similar images are integers in doubles too.
std::vector<CrustInput> integer_inputs() {
  std::vector<CrustInput> out;
  for (std::size_t k = 2; k <= 6; ++k) out.push_back({"lattice", integer_lattice(k).positions});
  out.push_back({"lattice circle", lattice_circle().positions});
  for (int i = 1; i <= 3; ++i) out.push_back({"foreign crossing", foreign_crossing(i).positions});
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    out.push_back({"few of a small grid", grid_draws(8 + seed, 5, seed)});
    out.push_back({"many of a grid", grid_draws(50, 12, 100 + seed)});
    out.push_back({"large grid", grid_draws(50, 1U << 20U, 200 + seed)});
  }
  return out;
}

std::vector<CrustInput> other_inputs() {
  std::vector<CrustInput> out;
  out.push_back({"smooth curve", benchmark_curve(150)});
  out.push_back({"rough curve", rough_curve(150)});
  out.push_back({"noisy curve", noisy_curve(120)});
  out.push_back({"square", uniform_square(100)});
  out.push_back({"duplicates", duplicate_heavy(200)});
  for (const TestShape& shape : oracle_shapes(0.45, {0.3, 0.2, 5})) out.push_back({shape.name, shape.data.positions});
  return out;
}

std::vector<CrustInput> all_inputs() {
  std::vector<CrustInput> out = integer_inputs();
  for (CrustInput& input : other_inputs()) out.push_back(std::move(input));
  for (DegenerateInput& input : degenerate_inputs()) out.push_back({input.name, std::move(input.positions)});
  return out;
}

std::vector<Vec2> distinct(std::vector<Vec2> points) {
  for (Vec2& p : points) p = p + Vec2{};  // -0.0 and 0.0 are one
  std::ranges::sort(points, lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Exact products are slow, so doubles answer where they can: products of exact differences of moderate size.
class SignOf {
 public:
  explicit SignOf(const std::vector<Vec2>& points) : points_(points), exact_(as_integers(points)) {
    for (const Vec2 p : points) largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y)});
    filtered_ = largest_ < 1e100 && common_exponent(points) > -400;
    bound_ = 32.0 * 0x1p-53 * largest_ * largest_;
  }
  /// Of (q - x).(r - x): negative when x lies strictly inside the circle over q r.
  int dot(std::size_t q, std::size_t r, std::size_t x) const {
    const double value = mes::dot(points_[q] - points_[x], points_[r] - points_[x]);
    if (filtered_ && std::abs(value) > bound_) return value > 0.0 ? 1 : -1;
    return sgn(test::dot(exact_[q] - exact_[x], exact_[r] - exact_[x]));
  }
  mpz_class exact_dot(std::size_t q, std::size_t r, std::size_t x) const {
    return test::dot(exact_[q] - exact_[x], exact_[r] - exact_[x]);
  }
  mpz_class exact_cross(std::size_t q, std::size_t r, std::size_t x) const {
    return test::cross(exact_[q] - exact_[x], exact_[r] - exact_[x]);
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<ExactPoint> exact_;
  double largest_ = 0.0;
  double bound_ = 0.0;
  bool filtered_ = false;
};

// For all pairs: the largest angles under which others see q r from the left and from the right add up to at most 90
// degrees. Knows nothing of triangulations.
std::set<PlaceEdge> crust_by_definition(const std::vector<Vec2>& points) {
  const SignOf sign(points);
  std::set<PlaceEdge> out;
  struct Cot {
    mpz_class along, side;  // side > 0
  };
  for (std::size_t q = 0; q < points.size(); ++q) {
    for (std::size_t r = q + 1; r < points.size(); ++r) {
      bool is_gabriel = true;
      for (std::size_t x = 0; x < points.size() && is_gabriel; ++x)
        is_gabriel = x == q || x == r || sign.dot(q, r, x) >= 0;
      if (!is_gabriel) continue;
      std::optional<Cot> least[2];
      for (std::size_t x = 0; x < points.size(); ++x) {
        if (x == q || x == r) continue;
        const mpz_class side = sign.exact_cross(q, r, x);
        if (side == 0) continue;
        const Cot cot{sign.exact_dot(q, r, x), abs(side)};
        std::optional<Cot>& best = least[side > 0 ? 0 : 1];
        if (!best || cot.along * best->side < best->along * cot.side) best = cot;
      }
      if (least[0] && least[1]) {
        const mpz_class left = least[0]->along * least[1]->along;
        const mpz_class right = least[0]->side * least[1]->side;
        if (left < right) continue;
      }
      out.insert(place_edge(points[q], points[r]));
    }
  }
  return out;
}

using IndexEdges = std::set<std::pair<std::size_t, std::size_t>>;

// The crust by indices into `points`, which must be distinct.
IndexEdges by_index(const std::set<PlaceEdge>& edges, const std::vector<Vec2>& points) {
  std::map<std::pair<double, double>, std::size_t> index;
  for (std::size_t i = 0; i < points.size(); ++i) index[{points[i].x, points[i].y}] = i;
  IndexEdges out;
  for (const auto& [a, b] : edges) out.insert(std::minmax(index.at(a), index.at(b)));
  return out;
}

IndexEdges crust_of(const std::vector<Vec2>& points) {
  const ComparedBench bench(points);
  return by_index(crust_edges(bench.graph()), points);
}

template <class List>
void shuffle(List& list, Rng& rng) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[rng.below(i)]);
}

// A circle's centre as fractions, in the units of `as_integers`.
struct Center {
  mpq_class x, y;
  friend bool operator==(const Center&, const Center&) = default;
};

Center center_of(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const ExactPoint u = b - a;
  const ExactPoint v = c - a;
  const mpz_class uu = dot(u, u);
  const mpz_class vv = dot(v, v);
  const mpz_class twice = 2 * cross(u, v);
  return {mpq_class(a.x) + fraction(v.y * uu - u.y * vv, twice),
          mpq_class(a.y) + fraction(u.x * vv - v.x * uu, twice)};
}

// Edges with a circle through both ends that holds no sample and no Voronoi vertex inside: all triples of samples,
// all pairs, in fractions.
IndexEdges crust_of_samples_and_voronoi_vertices(const std::vector<Vec2>& points) {
  const std::vector<ExactPoint> exact = as_integers(points);
  const std::size_t n = points.size();
  std::vector<Center> others;
  for (const ExactPoint& p : exact) others.push_back({p.x, p.y});
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        const int turn = sgn(cross(exact[b] - exact[a], exact[c] - exact[a]));
        if (turn == 0) continue;
        bool is_empty = true;
        for (std::size_t d = 0; d < n && is_empty; ++d)
          is_empty = turn * exact_in_circle(exact[a], exact[b], exact[c], exact[d]) <= 0;
        if (!is_empty) continue;
        const Center center = center_of(exact[a], exact[b], exact[c]);
        if (std::find(others.begin(), others.end(), center) == others.end()) others.push_back(center);
      }
    }
  }
  IndexEdges out;
  for (std::size_t q = 0; q < n; ++q) {
    for (std::size_t r = q + 1; r < n; ++r) {
      // Circles through q and r have the centre m + t n; another point bounds t from one side.
      std::optional<mpq_class> low;
      std::optional<mpq_class> high;
      bool possible = true;
      for (std::size_t i = 0; i < others.size() && possible; ++i) {
        if (i == q || i == r) continue;
        const Center& x = others[i];
        const mpq_class qx = x.x - exact[q].x;
        const mpq_class qy = x.y - exact[q].y;
        const mpq_class rx = x.x - exact[r].x;
        const mpq_class ry = x.y - exact[r].y;
        const mpq_class along = qx * rx + qy * ry;
        const mpq_class side = qx * ry - qy * rx;
        if (side == 0) {
          possible = along >= 0;
          continue;
        }
        const mpq_class bound = along / side;
        if (side > 0 && (!high || bound < *high)) high = bound;
        if (side < 0 && (!low || bound > *low)) low = bound;
        possible = !low || !high || *low <= *high;
      }
      if (possible) out.insert({q, r});
    }
  }
  return out;
}

}  // namespace

TEST_CASE("the crust is what its definition says, for all pairs of samples") {
  for (const CrustInput& input : all_inputs()) {
    const std::vector<Vec2> points = distinct(input.positions);
    if (points.size() > 260) continue;
    INFO(input.name << ", " << points.size() << " places");
    const ComparedBench bench(input.positions);
    CHECK(crust_edges(bench.graph()) == crust_by_definition(points));
  }
}

TEST_CASE("crust edges are Gabriel edges and cross their duals") {
  for (const CrustInput& input : all_inputs()) {
    INFO(input.name);
    const ComparedBench bench(input.positions);
    const std::vector<Vec2> points = distinct(input.positions);
    const SignOf sign(points);
    std::map<std::pair<double, double>, std::size_t> index;
    for (std::size_t i = 0; i < points.size(); ++i) index[{points[i].x, points[i].y}] = i;
    const auto& delaunay = bench.get<Delaunay>();
    const auto& crust = bench.get<OneStepCrust>();
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      const EdgeRow& row = delaunay.edge(edge);
      if (!row.is_alive() || !crust.is_crust(edge)) continue;
      const auto index_of = [&](SiteSlot site) {
        const Vec2 p = delaunay.site_position(site);
        return index.at({p.x, p.y});
      };
      const std::size_t q = index_of(row.v[0]);
      const std::size_t r = index_of(row.v[1]);
      for (std::size_t x = 0; x < points.size(); ++x)
        if (x != q && x != r && sign.dot(q, r, x) < 0) FAIL("a sample lies in the circle over a crust edge");
      if (row.f[0] == kNoSlot) continue;
      // Both ends of the dual on different sides of the edge: no apex sees it under more than 90 degrees, and an
      // apex that sees it under 90 has nothing opposite.
      const bool on_hull = delaunay.face(row.f[0]).is_infinite() || delaunay.face(row.f[1]).is_infinite();
      for (const FaceSlot face : row.f) {
        const SiteSlot apex = delaunay.apex(face, edge);
        if (apex == kInfiniteSite) continue;
        if (sign.dot(q, r, index_of(apex)) < (on_hull ? 0 : 1)) FAIL("a crust edge does not cross its dual");
      }
    }
  }
}

TEST_CASE("lattices have all their unit edges, whatever the order of insertion") {
  Rng rng(1);
  for (std::size_t k = 2; k <= 7; ++k) {
    DegenerateInput lattice = integer_lattice(k);
    const ComparedBench first(lattice.positions);
    INFO("k = " << k);
    const auto unit_edges = static_cast<std::int64_t>(2 * k * (k - 1));
    const auto odd = static_cast<std::int64_t>(4 * (k - 2));
    CHECK(first.count("one-step-crust", "crust_edges") == unit_edges);
    CHECK(first.count("one-step-crust", "odd_samples") == odd);
    for (const auto& [a, b] : crust_edges(first.graph()))
      CHECK(std::abs(a.first - b.first) + std::abs(a.second - b.second) == 1.0);
    for (int round = 0; round < 6; ++round) {
      shuffle(lattice.positions, rng);
      const ComparedBench shuffled(lattice.positions);
      CHECK(difference(first.state(), shuffled.state()) == "");
    }
  }
}

TEST_CASE("cocircular sets do not remember how they came about") {
  Rng rng(2);
  std::vector<CrustInput> inputs;
  for (std::size_t k = 3; k <= 5; ++k) inputs.push_back({"lattice", integer_lattice(k).positions});
  inputs.push_back({"lattice circle", lattice_circle().positions});
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    inputs.push_back({"grid draws", distinct(grid_draws(20, 6, 300 + seed))});
  for (CrustInput& input : inputs) {
    INFO(input.name);
    const ComparedBench batch(input.positions);
    const GeometryState expected = batch.state();
    for (int round = 0; round < 3; ++round) {
      shuffle(input.positions, rng);
      // One by one.
      ComparedBench one_by_one;
      for (const Vec2 p : input.positions) one_by_one.insert({p});
      CHECK(difference(one_by_one.state(), expected) == "");
      // With others among them that go again.
      ComparedBench detour(input.positions);
      std::vector<Vec2> guests;
      for (int i = 0; i < 7; ++i) guests.push_back({rng.uniform(-3.0, 8.0), rng.uniform(-3.0, 8.0)});
      detour.insert(guests);
      std::vector<SampleId> ids = detour.ids();
      ids.erase(ids.begin(), ids.end() - 7);
      for (const SampleId id : ids) detour.remove({id});
      CHECK(difference(detour.state(), expected) == "");
      // Each sample away and back.
      ComparedBench shaken(input.positions);
      for (const SampleId id : shaken.ids()) {
        const Vec2 home = shaken.document().position(shaken.document().slot_of(id));
        shaken.move(id, home + Vec2{rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)});
        shaken.move(id, home);
      }
      CHECK(difference(shaken.state(), expected) == "");
    }
  }
}

TEST_CASE("the crust goes along with similarities") {
  const auto image = [](std::vector<Vec2> points, auto map) {
    for (Vec2& p : points) p = map(p);
    return points;
  };
  for (const bool integers : {true, false}) {
    for (const CrustInput& input : integers ? integer_inputs() : other_inputs()) {
      INFO(input.name);
      const std::vector<Vec2> points = distinct(input.positions);
      const IndexEdges expected = crust_of(points);
      CHECK(crust_of(image(points, [](Vec2 p) { return perpendicular(p); })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return Vec2{-p.x, p.y}; })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return Vec2{p.y, p.x}; })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return 0x1p-300 * p; })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return 0x1p70 * p; })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return 0x1p400 * p; })) == expected);
      if (!integers) continue;
      CHECK(crust_of(image(points, [](Vec2 p) { return p + Vec2{1e15, -1e15}; })) == expected);
      CHECK(crust_of(image(points, [](Vec2 p) { return p + Vec2{-7.0, 123456789.0}; })) == expected);
      // Turned by the argument of 3 + 4i and enlarged by 5.
      CHECK(crust_of(image(points, [](Vec2 p) { return Vec2{3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y}; })) == expected);
    }
  }
}

TEST_CASE("the crust contains the crust of Amenta, Bern and Eppstein") {
  std::vector<CrustInput> inputs;
  for (std::size_t k = 2; k <= 4; ++k) inputs.push_back({"lattice", integer_lattice(k).positions});
  for (int i = 1; i <= 3; ++i) inputs.push_back({"foreign crossing", foreign_crossing(i).positions});
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    inputs.push_back({"few of a small grid", grid_draws(12, 5, 400 + seed)});
    inputs.push_back({"few of a grid", grid_draws(14, 40, 500 + seed)});
  }
  inputs.push_back({"curve", ellipse(2.0, 1.0, 20).data.positions});
  inputs.push_back({"annulus", annulus_aligned(1.0, 2.0, 10).data.positions});
  inputs.push_back({"square", uniform_square(18)});
  std::size_t contained = 0;
  std::size_t more = 0;
  for (const CrustInput& input : inputs) {
    INFO(input.name);
    const std::vector<Vec2> points = distinct(input.positions);
    const IndexEdges global = crust_of_samples_and_voronoi_vertices(points);
    const IndexEdges local = crust_of(points);
    CHECK(std::ranges::includes(local, global));
    contained += global.size();
    more += local.size() - global.size();
  }
  // The two differ, so that the inclusion says something.
  CHECK(contained > 100);
  CHECK(more > 10);
}

TEST_CASE("samples on no curve are counted and found, and are no doubt about the others") {
  TestBench bench;
  bench.show({"curve"});
  bench.replace(ellipse(2.0, 1.0, 60).data.positions);
  const auto& crust = bench.get<OneStepCrust>();
  const auto findings = [&] {
    std::vector<Finding> out;
    crust.find(out);
    return out;
  };
  CHECK(crust.lone_count() == 0);
  CHECK(findings().empty());
  bench.insert({{40, 30}});
  CHECK(crust.lone_count() == 1);
  REQUIRE(findings().size() == 1);
  CHECK(findings()[0].level == FindingLevel::note);
  CHECK(findings()[0].count == 1);
  CHECK(findings()[0].places == std::vector<Vec2>{{40, 30}});
  bench.remove({bench.ids().back()});
  CHECK(crust.lone_count() == 0);
  // Where nothing is joined, no sample is beside a curve.
  bench.replace({{0, 0}});
  CHECK(crust.lone_count() == 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The crust test and the orders that the label rule needs, against integers of any size: at random, one last bit from
// a tie, on ties, on the hull, at both ends of the range of doubles, and far from the origin.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <complex>
#include <functional>

#include "core/base/rng.h"
#include "tests/support/exact_geometry.h"

using namespace mes;
using namespace mes::test;

namespace {

Vec2 scaled_point(Vec2 p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}
Vec2 turned(Vec2 p) {
  return perpendicular(p);
}

EdgeCorners mapped(const EdgeCorners& e, const std::function<Vec2(Vec2)>& map) {
  EdgeCorners out{map(e.p), map(e.q), map(e.r), {}};
  if (e.s) out.s = map(*e.s);
  return out;
}
EdgeCorners mirrored(const EdgeCorners& e) {
  // The mirror image of a left apex is on the right; going backwards puts it left again.
  const auto mirror = [](Vec2 p) { return Vec2{-p.x, p.y}; };
  const EdgeCorners image = mapped(e, mirror);
  return {image.p, image.r, image.q, image.s};
}
EdgeCorners from_the_other_side(const EdgeCorners& e) {
  return {*e.s, e.r, e.q, e.p};
}

bool is_delaunay_edge(const EdgeCorners& e) {
  if (exact_side(e.q, e.r, e.p) <= 0) return false;
  return !e.s || (exact_side(e.q, e.r, *e.s) < 0 && exact_edge(e).is_delaunay());
}

// Some Delaunay edge among four points, or the hull edge of three; nothing when they are degenerate.
std::optional<EdgeCorners> edge_of(const std::array<Vec2, 4>& v, bool hull) {
  for (const auto& [a, b, c, d] : {std::array{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}) {
    const auto at = [&v](int i) { return v[static_cast<std::size_t>(i)]; };
    for (const bool swap : {false, true}) {
      EdgeCorners corners{at(swap ? d : c), at(a), at(b), at(swap ? c : d)};
      if (hull) corners.s.reset();
      if (is_delaunay_edge(corners)) return corners;
    }
  }
  return {};
}

using PointMaker = std::function<Vec2(Rng&)>;

struct Source {
  const char* name;
  PointMaker point;
};

std::vector<Source> sources() {
  const auto unit = [](Rng& rng) { return Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}; };
  const auto grid = [](Rng& rng, std::uint64_t size) {
    return Vec2{static_cast<double>(rng.below(size)), static_cast<double>(rng.below(size))};
  };
  const auto wide = [](Rng& rng, int range) {
    const auto value = [&rng, range] {
      const int exponent = static_cast<int>(rng.below(static_cast<std::uint64_t>(2 * range + 1))) - range;
      return std::ldexp(rng.uniform(-1.0, 1.0), exponent);
    };
    const double x = value();
    return Vec2{x, value()};
  };
  return {{"unit square", unit},
          {"small grid", [grid](Rng& rng) { return grid(rng, 5); }},
          {"grid of 2^26", [grid](Rng& rng) { return grid(rng, 1U << 26U); }},
          {"near the smallest doubles", [unit](Rng& rng) { return scaled_point(unit(rng), -996); }},
          {"denormals", [grid](Rng& rng) { return scaled_point(grid(rng, 40), -1074); }},
          {"near the largest doubles", [unit](Rng& rng) { return scaled_point(unit(rng), 1023); }},
          {"where the static filter begins", [unit](Rng& rng) { return 1e-70 * unit(rng); }},
          {"where the static filter ends", [unit](Rng& rng) { return 0.5e70 * unit(rng); }},
          {"at 1e15",
           [grid](Rng& rng) {
             return 0.125 * grid(rng, 64) + Vec2{1e15, -1e15};
           }},
          {"sizes over 2^40", [wide](Rng& rng) { return wide(rng, 20); }},
          {"sizes over 2^1000", [wide](Rng& rng) { return wide(rng, 500); }},
          {"sizes over 2^2000", [wide](Rng& rng) { return wide(rng, 1000); }},
          {"almost on a line",
           [](Rng& rng) {
             return Vec2{rng.uniform(), 1e-17 * rng.uniform()};
           }},
          {"almost on a circle", [](Rng& rng) {
             const double t = 6.283185307179586 * rng.uniform();
             return Vec2{std::cos(t), std::sin(t)};
           }}};
}

using Gauss = std::complex<std::int64_t>;

Vec2 as_vec(Gauss z) {
  return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

// With Gaussian integers an angle is the argument of g = (r - p) / (q - p), and the sum of the two angles is the
// argument of g g'. Both apexes fit one edge when q - p = u (g' - 1) and r - s = -u (g - 1).
EdgeCorners with_angles(Gauss g, Gauss g_right, Gauss u, Gauss origin) {
  const Gauss p = origin;
  const Gauss to_q = u * (g_right - Gauss(1));
  const Gauss q = p + to_q;
  const Gauss r = p + to_q * g;
  const Gauss s = r + u * (g - Gauss(1));
  return {as_vec(p), as_vec(q), as_vec(r), as_vec(s)};
}

Gauss random_gauss(Rng& rng, std::int64_t size, bool upper) {
  for (;;) {
    const auto n = static_cast<std::uint64_t>(2 * size + 1);
    const Gauss z(static_cast<std::int64_t>(rng.below(n)) - size, static_cast<std::int64_t>(rng.below(n)) - size);
    if (z != Gauss(0) && (!upper || z.imag() > 0)) return z;
  }
}

// alpha + beta = 90 degrees exactly; both angles acute.
EdgeCorners right_sum(Rng& rng) {
  for (;;) {
    const Gauss g = random_gauss(rng, 30, true);
    if (g.real() <= 0) continue;
    const Gauss g_right = Gauss(0, 1) * std::conj(g) * Gauss(1 + static_cast<std::int64_t>(rng.below(3)));
    if (g_right == Gauss(1)) continue;
    const EdgeCorners e = with_angles(g, g_right, random_gauss(rng, 20, false), random_gauss(rng, 1000, false));
    if (is_delaunay_edge(e)) return e;
  }
}

// alpha + beta = 180 degrees exactly.
EdgeCorners cocircular(Rng& rng) {
  for (;;) {
    const Gauss g = random_gauss(rng, 30, true);
    const Gauss g_right = -std::conj(g) * Gauss(1 + static_cast<std::int64_t>(rng.below(3)));
    const EdgeCorners e = with_angles(g, g_right, random_gauss(rng, 20, false), random_gauss(rng, 1000, false));
    if (is_delaunay_edge(e)) return e;
  }
}

// The right angle of a hull edge: p on the circle over q r.
EdgeCorners right_hull(Rng& rng) {
  for (;;) {
    const Gauss p = random_gauss(rng, 1000, false);
    const Gauss to_q = random_gauss(rng, 1000, false);
    const Gauss to_r = Gauss(0, 1 + static_cast<std::int64_t>(rng.below(5))) * to_q;
    const EdgeCorners e{as_vec(p), as_vec(p + to_q), as_vec(p + to_r), {}};
    if (is_delaunay_edge(e)) return e;
  }
}

// One coordinate of one corner goes to the next double.
EdgeCorners one_bit_off(EdgeCorners e, Rng& rng) {
  Vec2* corners[] = {&e.p, &e.q, &e.r, e.s ? &*e.s : &e.p};
  Vec2& corner = *corners[rng.below(4)];
  double& value = rng.below(2) == 0 ? corner.x : corner.y;
  value = std::nextafter(value, rng.below(2) == 0 ? 1e300 : -1e300);
  return e;
}

std::uint64_t total(const FilterCounts& counts) {
  return counts.static_filter + counts.interval + counts.exact;
}

void check_class(const EdgeCorners& e, FilterCounts& counts) {
  const ExactEdge exact = exact_edge(e);
  const std::uint64_t before = total(counts);
  const EdgeClass answer = classify_edge(e, counts);
  if (answer.is_crust != exact.is_crust()) FAIL("wrong crust bit, exact " << exact.is_crust());
  if (answer.is_cocircular != exact.is_cocircular()) FAIL("wrong cocircular bit, exact " << exact.is_cocircular());
  if (total(counts) != before + 1) FAIL("a call was counted " << total(counts) - before << " times");
  if (!e.s) return;
  const EdgeClass other = classify_edge(from_the_other_side(e), counts);
  if (other.is_crust != answer.is_crust || other.is_cocircular != answer.is_cocircular)
    FAIL("the two sides disagree");
}

// The lifted determinant, which is another polynomial than the product of phases.
void check_in_circle(const EdgeCorners& e) {
  const std::vector<Vec2> points{e.p, e.q, e.r, *e.s};
  const auto exact = as_integers(points);
  FilterCounts counts;
  const bool on_circle = exact_in_circle(exact[0], exact[1], exact[2], exact[3]) == 0;
  if (classify_edge(e, counts).is_cocircular != on_circle) FAIL("in-circle determinant disagrees");
}

// What key and confidence should be: cosine and sine of the exact sum of angles.
struct Trigonometry {
  double cosine, sine;
};
Trigonometry trigonometry(const ExactEdge& edge) {
  const ExactCot cot = edge.cot_of_sum();
  if (!cot) return {-1.0, 0.0};
  const bool is_steep = abs(*cot) > mpq_class(1e200);
  if (is_steep) return {sgn(*cot) < 0 ? -1.0 : 1.0, 0.0};
  const double c = cot->get_d();
  return {c / std::hypot(1.0, c), 1.0 / std::hypot(1.0, c)};
}

void check_measures(const EdgeCorners& e) {
  const auto [cosine, sine] = trigonometry(exact_edge(e));
  const double key = std::abs(cosine) <= sine ? std::abs(cosine) : std::sqrt(2.0) - sine;
  const double confidence = edge_confidence(e);
  if (!(std::abs(confidence - cosine) < 1e-13)) FAIL("confidence " << confidence << " but cos is " << cosine);
  if (!(std::abs(ambiguity_key(e) - key) < 0.5 * kAmbiguityKeyError))
    FAIL("key " << ambiguity_key(e) << " but it should be " << key);
}

std::string text(const EdgeCorners& e) {
  std::ostringstream out;
  out << std::hexfloat << "p " << e.p.x << ' ' << e.p.y << " q " << e.q.x << ' ' << e.q.y << " r " << e.r.x << ' '
      << e.r.y;
  if (e.s) out << " s " << e.s->x << ' ' << e.s->y;
  return out.str();
}

// Edges of every kind, for the checks that want variety.
std::vector<EdgeCorners> all_kinds(std::uint64_t seed, int of_each) {
  std::vector<EdgeCorners> out;
  Rng rng(seed);
  for (const Source& source : sources()) {
    for (int i = 0; i < of_each; ++i) {
      const std::array points{source.point(rng), source.point(rng), source.point(rng), source.point(rng)};
      if (const auto e = edge_of(points, rng.below(5) == 0)) out.push_back(*e);
    }
  }
  for (int i = 0; i < of_each; ++i) {
    for (const EdgeCorners& tie : {right_sum(rng), cocircular(rng), right_hull(rng)}) {
      out.push_back(tie);
      const int exponent = static_cast<int>(rng.below(1900)) - 980;
      out.push_back(mapped(tie, [exponent](Vec2 p) { return scaled_point(p, exponent); }));
      const EdgeCorners near = one_bit_off(tie, rng);
      if (is_delaunay_edge(near)) out.push_back(near);
      // Not ties any more, but as near to them as rounding leaves it.
      const EdgeCorners rounded = mapped(tie, [](Vec2 p) { return 0.1 * p; });
      if (is_delaunay_edge(rounded)) out.push_back(rounded);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("the crust test is exact for random corners of every size") {
  for (const Source& source : sources()) {
    Rng rng(1);
    FilterCounts counts;
    int edges = 0;
    for (int i = 0; i < 1500; ++i) {
      const std::array points{source.point(rng), source.point(rng), source.point(rng), source.point(rng)};
      const auto e = edge_of(points, i % 5 == 0);
      if (!e) continue;
      INFO(source.name << ' ' << text(*e));
      check_class(*e, counts);
      if (e->s) check_in_circle(*e);
      ++edges;
    }
    INFO(source.name);
    CHECK(edges > 400);
  }
}

TEST_CASE("ties are crust, and one last bit decides") {
  Rng rng(2);
  FilterCounts counts;
  int crust_near = 0;
  int skeleton_near = 0;
  for (int i = 0; i < 2000; ++i) {
    for (const EdgeCorners& tie : {right_sum(rng), right_hull(rng)}) {
      INFO(text(tie));
      REQUIRE(classify_edge(tie, counts).is_crust);
      check_class(tie, counts);
      const EdgeCorners near = one_bit_off(tie, rng);
      if (!is_delaunay_edge(near)) continue;
      check_class(near, counts);
      (exact_edge(near).is_crust() ? crust_near : skeleton_near) += 1;
    }
  }
  // Otherwise these trials would not have been near anything.
  CHECK(crust_near > 500);
  CHECK(skeleton_near > 500);
}

TEST_CASE("cocircular corners are recognised, and one last bit ends it") {
  Rng rng(3);
  FilterCounts counts;
  int near_misses = 0;
  for (int i = 0; i < 2000; ++i) {
    const EdgeCorners tie = cocircular(rng);
    INFO(text(tie));
    const EdgeClass answer = classify_edge(tie, counts);
    REQUIRE(answer.is_cocircular);
    REQUIRE_FALSE(answer.is_crust);
    check_class(tie, counts);
    check_in_circle(tie);
    const EdgeCorners near = one_bit_off(tie, rng);
    if (!is_delaunay_edge(near)) continue;
    check_class(near, counts);
    near_misses += exact_edge(near).is_cocircular() ? 0 : 1;
  }
  CHECK(near_misses > 500);
  FilterCounts hull_counts;
  CHECK_FALSE(classify_edge(right_hull(rng), hull_counts).is_cocircular);
}

TEST_CASE("the crust test does not see similarities that doubles hold exactly") {
  Rng rng(4);
  FilterCounts counts;
  for (const EdgeCorners& e : all_kinds(4, 60)) {
    INFO(text(e));
    const EdgeClass answer = classify_edge(e, counts);
    const auto same = [&](const EdgeCorners& image) {
      const EdgeClass other = classify_edge(image, counts);
      return other.is_crust == answer.is_crust && other.is_cocircular == answer.is_cocircular;
    };
    CHECK(same(mapped(e, turned)));
    CHECK(same(mapped(e, [](Vec2 p) { return -p; })));
    CHECK(same(mirrored(e)));
  }
  for (int i = 0; i < 300; ++i) {
    for (const EdgeCorners& e : {right_sum(rng), cocircular(rng), right_hull(rng)}) {
      INFO(text(e));
      const EdgeClass answer = classify_edge(e, counts);
      for (const int exponent : {-1060, -600, -40, 40, 600, 990}) {
        const EdgeClass image = classify_edge(mapped(e, [=](Vec2 p) { return scaled_point(p, exponent); }), counts);
        REQUIRE(image.is_crust == answer.is_crust);
        REQUIRE(image.is_cocircular == answer.is_cocircular);
      }
      for (const Vec2 shift : {Vec2{1e15, 1e15}, Vec2{-4e15, 7.0}, Vec2{12345.0, -1e12}}) {
        const EdgeClass image = classify_edge(mapped(e, [=](Vec2 p) { return p + shift; }), counts);
        REQUIRE(image.is_crust == answer.is_crust);
        REQUIRE(image.is_cocircular == answer.is_cocircular);
      }
    }
  }
}

TEST_CASE("easy edges cost no more than the static filter, ties off a grid go to the exact stage") {
  FilterCounts easy;
  for (int i = 0; i < 100; ++i) {
    const double height = 1.3 + 0.01 * i;
    REQUIRE(classify_edge({{0.5, height}, {0, 0}, {1, 0}, Vec2{0.5, -height}}, easy).is_crust);
    REQUIRE(classify_edge({{0.5, height}, {0, 0}, {1, 0}, {}}, easy).is_crust);
  }
  CHECK(easy.static_filter == 200);
  CHECK(easy.interval == 0);
  CHECK(easy.exact == 0);

  Rng rng(5);
  FilterCounts ties;
  for (int i = 0; i < 100; ++i) {
    classify_edge(right_sum(rng), ties);
    classify_edge(right_hull(rng), ties);
  }
  // Ties on a coarse grid are decided by doubles that do not round, all others exactly.
  CHECK(ties.interval == 0);
  CHECK(ties.static_filter + ties.exact == 200);
  CHECK(ties.exact > 50);
  FilterCounts grid;
  CHECK(classify_edge({{0, 1}, {0, 0}, {1, 0}, Vec2{1, -1}}, grid).is_crust);
  CHECK(classify_edge({{0, 0}, {1, 0}, {0, 1}, Vec2{1, 1}}, grid).is_cocircular);
  CHECK(grid.static_filter == 2);
  // A bit off the grid, and the tie is none.
  CHECK_FALSE(classify_edge({{0, 1}, {0, 0}, {1, 0}, Vec2{1, std::nextafter(-1.0, 0.0)}}, grid).is_crust);
  CHECK(grid.static_filter == 2);

  // Beyond the range of the static filter its neighbour decides, without exact numbers.
  FilterCounts large;
  for (int i = 0; i < 100; ++i) {
    const double height = (1.3 + 0.01 * i) * 1e75;
    REQUIRE(classify_edge({{0.5e75, height}, {0, 0}, {1e75, 0}, Vec2{0.5e75, -height}}, large).is_crust);
  }
  CHECK(large.interval == 100);
}

TEST_CASE("the error of the double evaluation stays below the static filter's bound") {
  Rng rng(6);
  const auto value = [&rng](int spread) {
    return std::ldexp(rng.uniform(-1.0, 1.0), -static_cast<int>(rng.below(static_cast<std::uint64_t>(spread))));
  };
  double worst = 0.0;
  double worst_hull = 0.0;
  for (int i = 0; i < 30000; ++i) {
    const int spread = 1 + i % 30;
    const auto point = [&] {
      const double x = value(spread);
      return Vec2{x, value(spread)};
    };
    const EdgeCorners e{point(), point(), point(), point()};
    const std::vector<Vec2> points{e.p, e.q, e.r, *e.s};
    const int exponent = common_exponent(points);
    const auto exact = as_integers(points);
    const ExactPoint pq = exact[1] - exact[0];
    const ExactPoint pr = exact[2] - exact[0];
    const ExactPoint sr = exact[2] - exact[3];
    const ExactPoint sq = exact[1] - exact[3];
    const mpz_class dp = dot(pq, pr);
    const mpz_class xp = cross(pq, pr);
    const mpz_class ds = dot(sr, sq);
    const mpz_class xs = cross(sr, sq);
    const auto difference = [&](Vec2 a, Vec2 b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); };
    const double hull_size = std::max(difference(e.q, e.p), difference(e.r, e.p));
    const double size = std::max({hull_size, difference(e.q, *e.s), difference(e.r, *e.s)});
    // |computed - exact| / (u size^degree), where the exact value is an integer times 2^(degree exponent).
    const auto error = [&](double computed, const mpz_class& integer, int degree, double reach) {
      mpq_class truth(integer);
      mpq_class unit(1);
      unit <<= static_cast<unsigned>(-degree * exponent);
      truth /= unit;
      const mpq_class gap = abs(mpq_class(computed) - truth);
      return gap.get_d() / (0x1p-53 * std::pow(reach, degree));
    };
    const Phase phase = phase_of(e);
    const mpz_class h = dp * ds - xp * xs;
    const mpz_class imaginary = xp * ds + dp * xs;
    worst = std::max({worst, error(phase.h, h, 4, size), error(phase.i, imaginary, 4, size)});
    const EdgeCorners hull{e.p, e.q, e.r, {}};
    worst_hull = std::max(worst_hull, error(phase_of(hull).h, dp, 2, hull_size));
  }
  INFO("largest error " << worst << ", hull " << worst_hull);
  CHECK(worst < 80.1);
  CHECK(worst > 1.0);
  CHECK(worst_hull < 8.0);
  CHECK(worst_hull > 0.3);
}

TEST_CASE("confidence and sort key are the cosine and sine of the exact sum of angles") {
  for (const EdgeCorners& e : all_kinds(7, 150)) {
    INFO(text(e));
    check_measures(e);
  }
}

TEST_CASE("the order of ambiguity is exact") {
  std::vector<EdgeCorners> edges = all_kinds(8, 25);
  Rng rng(8);
  std::vector<ExactCot> exact;
  for (const EdgeCorners& e : edges) exact.push_back(exact_edge(e).certainty());
  int looks = 0;
  const std::vector<std::uint32_t> place = ambiguity_places(edges, [&looks] { ++looks; });
  CHECK(looks > 0);
  REQUIRE(place.size() == edges.size());
  for (int i = 0; i < 6000; ++i) {
    const std::size_t a = rng.below(edges.size());
    const std::size_t b = rng.below(edges.size());
    INFO(text(edges[a]) << " / " << text(edges[b]));
    const int order = compare(exact[a], exact[b]);
    const int answer = compare_ambiguity(edges[a], edges[b]);
    if (answer != order) FAIL("wrong order " << answer << ", exact " << order);
    const int by_place = place[a] < place[b] ? -1 : (place[b] < place[a] ? 1 : 0);
    if (by_place != order) FAIL("wrong places " << place[a] << " and " << place[b] << ", exact order " << order);
    if (compare_ambiguity(edges[b], edges[a]) != -order) FAIL("the order depends on which edge is asked first");
    const double keys = ambiguity_key(edges[a]) - ambiguity_key(edges[b]);
    if (std::abs(keys) > kAmbiguityKeyError && (keys > 0.0 ? 1 : -1) != order) FAIL("the keys are in another order");
  }
}

TEST_CASE("edges of equal ambiguity compare equal") {
  Rng rng(9);
  int nearly_equal = 0;
  int supplements = 0;
  for (int i = 0; i < 400; ++i) {
    const Gauss g = random_gauss(rng, 20, true);
    const Gauss g_right = random_gauss(rng, 20, true);
    const EdgeCorners e = with_angles(g, g_right, random_gauss(rng, 20, false), {});
    if (!is_delaunay_edge(e)) continue;
    // The same angles in other triangles: turned, scaled, stretched legs, mirrored, on the other side.
    const EdgeCorners same = with_angles(g, g_right, random_gauss(rng, 20, false), random_gauss(rng, 100, false));
    const EdgeCorners longer = with_angles(Gauss(2) * g, Gauss(3) * g_right, random_gauss(rng, 20, false), {});
    for (const EdgeCorners& other : {same, longer, mirrored(e), from_the_other_side(e)}) {
      INFO(text(e) << " / " << text(other));
      REQUIRE(is_delaunay_edge(other));
      CHECK(compare_ambiguity(e, other) == 0);
      CHECK(std::abs(ambiguity_key(e) - ambiguity_key(other)) <= kAmbiguityKeyError);
    }
    // A sum and its supplement have the same |cot|.
    const Gauss other_angle = random_gauss(rng, 5, true);
    const Gauss rest = -std::conj(g * g_right * other_angle);
    if (rest.imag() > 0) {
      const EdgeCorners supplement = with_angles(other_angle, rest, {1, 2}, {});
      if (is_delaunay_edge(supplement)) {
        CHECK(compare_ambiguity(e, supplement) == 0);
        ++supplements;
      }
    }
    const EdgeCorners near = one_bit_off(e, rng);
    if (!is_delaunay_edge(near)) continue;
    const int order = compare(exact_edge(e).certainty(), exact_edge(near).certainty());
    CHECK(compare_ambiguity(e, near) == order);
    nearly_equal += order != 0 ? 1 : 0;
  }
  CHECK(nearly_equal > 50);
  CHECK(supplements > 20);
  const EdgeCorners circle = cocircular(rng);
  CHECK(compare_ambiguity(circle, cocircular(rng)) == 0);
  CHECK(compare_ambiguity(circle, right_sum(rng)) == 1);
  CHECK(compare_ambiguity(right_sum(rng), right_hull(rng)) == 0);
}

TEST_CASE("the order of lengths is exact") {
  const auto exact_order = [](Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const std::vector<Vec2> points{a, b, c, d};
    const auto exact = as_integers(points);
    const ExactPoint u = exact[1] - exact[0];
    const ExactPoint v = exact[3] - exact[2];
    const mpz_class gap = dot(u, u) - dot(v, v);
    return sgn(gap);
  };
  Rng rng(10);
  int ties = 0;
  int near = 0;
  for (const Source& source : sources()) {
    for (int i = 0; i < 500; ++i) {
      const Vec2 a = source.point(rng);
      const Vec2 b = source.point(rng);
      const Vec2 c = source.point(rng);
      const Vec2 d = source.point(rng);
      INFO(source.name);
      CHECK(compare_lengths(a, b, c, d) == exact_order(a, b, c, d));
      CHECK(compare_lengths(c, d, a, b) == -exact_order(a, b, c, d));
      // The same vector turned by 90 degrees at the origin, and one last bit longer or shorter.
      const Vec2 turned_b = turned(b);
      CHECK(compare_lengths({}, b, turned_b, {}) == 0);
      ++ties;
      const Vec2 off{std::nextafter(turned_b.x, rng.below(2) == 0 ? 1e308 : -1e308), turned_b.y};
      const int order = exact_order({}, b, {}, off);
      CHECK(compare_lengths({}, b, {}, off) == order);
      near += order != 0 ? 1 : 0;
    }
  }
  CHECK(near > ties / 2);
}

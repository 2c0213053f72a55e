// SPDX-License-Identifier: GPL-3.0-or-later
// What outlines have in common is sampled once, and every outline goes through these samples.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/base/rng.h"
#include "core/curves/cuts.h"
#include "core/curves/internal/contacts.h"
#include "core/curves/resolution.h"
#include "core/curves/sampling.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/parcels.h"
#include "tests/support/pi.h"

using namespace mes;
using namespace mes::test;
using mes::test::kPi;

namespace {

using Link = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::uint32_t> places_of(const SampledCurves& samples, const SampledCurves::Chain& chain) {
  std::vector<std::uint32_t> out;
  for (std::size_t i = chain.first; i < chain.first + chain.count; ++i)
    out.push_back(samples.order.empty() ? static_cast<std::uint32_t>(i) : samples.order[i]);
  return out;
}

/// How many times chains link two samples.
std::map<Link, int> links_of(const SampledCurves& samples) {
  std::map<Link, int> out;
  for (const SampledCurves::Chain& chain : samples.chains) {
    const std::vector<std::uint32_t> places = places_of(samples, chain);
    for (std::size_t i = 0; i + (chain.is_closed ? 0 : 1) < places.size(); ++i) {
      const std::uint32_t a = places[i];
      const std::uint32_t b = places[(i + 1) % places.size()];
      ++out[{std::min(a, b), std::max(a, b)}];
    }
  }
  return out;
}

double length_of_links(const SampledCurves& samples, const std::map<Link, int>& links, int count) {
  double sum = 0.0;
  for (const auto& [link, times] : links)
    if (times == count) sum += distance(samples.positions[link.first], samples.positions[link.second]);
  return sum;
}

CurveSet set_of(std::vector<PlaneCurve> curves) {
  CurveSet out{.curves = std::move(curves)};
  double coarsest = 1.0;
  for (const PlaneCurve& curve : out.curves)
    if (coarsest > 0.0) coarsest = std::min(coarsest, resolution_of(curve.points()));
  out.resolution = coarsest;
  return out;
}

SampledCurves sampled_together(const CurveSet& curves, const SamplingRequest& request) {
  auto samples = sample(curves, request);
  REQUIRE(samples.has_value());
  return *std::move(samples);
}

bool are_all_different(std::vector<Vec2> points) {
  std::ranges::sort(points, [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return std::ranges::adjacent_find(points) == points.end();
}

PlaneCurve rectangle(double x0, double y0, double x1, double y1) {
  return closed_polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

}  // namespace

TEST_CASE("parcels link the samples of their borders twice, and those of the outside once") {
  constexpr double kPerimeter = 320.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const int decimals = 4 + static_cast<int>(seed % 3) * 3;
    const double angle = seed % 4 == 0 ? 0.0 : 0.1 * static_cast<double>(seed);
    const Parcels made = parcels(2 + seed, angle, decimals, seed);
    const CurveSet curves = set_of(made.outlines);
    double all = 0.0;
    for (const Box2& box : made.boxes) all += 2.0 * (box.width() + box.height());
    for (const SamplingRequest& request :
         std::vector<SamplingRequest>{{.rule = SamplingRule::vertices},
                                      {.rule = SamplingRule::spacing, .spacing = 0.7},
                                      {.rule = SamplingRule::count, .count = 700},
                                      {.rule = SamplingRule::adaptive, .count = 700, .least_each = 8},
                                      default_sampling(curves)}) {
      INFO("seed " << seed << ", rule " << static_cast<int>(request.rule));
      const SampledCurves samples = sampled_together(curves, request);
      REQUIRE(samples.chains.size() == made.outlines.size());
      CHECK(are_all_different(samples.positions));
      const std::map<Link, int> links = links_of(samples);
      CHECK(std::ranges::all_of(links, [](const auto& link) { return link.second == 1 || link.second == 2; }));
      CHECK(length_of_links(samples, links, 1) == Approx(kPerimeter).epsilon(1e-4));
      CHECK(length_of_links(samples, links, 2) == Approx(0.5 * (all - kPerimeter)).epsilon(1e-4));
      for (std::size_t i = 0; i < samples.chains.size(); ++i) {
        std::vector<std::uint32_t> places = places_of(samples, samples.chains[i]);
        for (const Vec2 corner : made.outlines[i].points())
          CHECK(std::ranges::any_of(places, [&](std::uint32_t place) {
            return distance(samples.positions[place], corner) <= 3.0 * curves.resolution + 1e-9;
          }));
        std::ranges::sort(places);
        CHECK(std::ranges::adjacent_find(places) == places.end());
      }
    }
  }
}

TEST_CASE("outlines that touch nowhere are sampled as each by itself") {
  std::vector<PlaneCurve> apart{rectangle(0, 0, 4, 3), rectangle(4.001, 0, 8, 3), rectangle(1, 1, 2, 2),
                                rectangle(0, 4, 500, 5), rectangle(0, 6, 500, 7)};
  const CurveSet curves = set_of(apart);
  const SampledCurves samples = sampled_together(curves, {.rule = SamplingRule::spacing, .spacing = 0.25});
  CHECK(samples.order.empty());
  std::vector<Vec2> each;
  for (const PlaneCurve& curve : apart) {
    const SampledCurves one = sampled_together({.curves = {curve}}, {.rule = SamplingRule::spacing, .spacing = 0.25});
    each.insert(each.end(), one.positions.begin(), one.positions.end());
  }
  CHECK(samples.positions == each);
}

TEST_CASE("arcs and cubics that two outlines have in common are one") {
  const EllipticArc half{{0, 0}, {2, 0}, {0, 2}, 0.0, kPi};
  PlaneCurve upper({2, 0});
  upper.arc_to(half, {-2, 0});
  upper.cubic_to({-1, -1}, {1, 1}, {2, 0});
  upper.close();
  // The same cubic backwards, and the rest of a box below.
  PlaneCurve lower({2, 0});
  lower.cubic_to({1, 1}, {-1, -1}, {-2, 0});
  lower.line_to({-2, -3});
  lower.line_to({2, -3});
  lower.close();
  const SampledCurves samples =
      sampled_together(set_of({upper, lower}), {.rule = SamplingRule::spacing, .spacing = 0.1});
  const std::map<Link, int> links = links_of(samples);
  double along = 0.0;
  upper.for_each_piece([&](const Piece& piece) {
    if (piece.kind != PieceKind::cubic) return;
    for (int i = 0; i < 1000; ++i) along += distance(piece.at(i / 1000.0), piece.at((i + 1) / 1000.0));
  });
  CHECK(length_of_links(samples, links, 2) == Approx(along).epsilon(1e-3));
  CHECK(length_of_links(samples, links, 1) == Approx(2.0 * kPi + 10.0).epsilon(1e-3));
  CHECK(are_all_different(samples.positions));
}

TEST_CASE("of many nested circles a line meets the one on which it begins") {
  constexpr int kCircles = 400;
  std::vector<PlaneCurve> curves;
  for (int i = 1; i <= kCircles; ++i) curves.push_back(circle_around({0.5, 0.25}, i));
  std::vector<Vec2> begins;
  for (int i = 1; i <= kCircles; i += 21) {
    const double angle = 0.3 * i;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    const auto rounded = [](Vec2 p) { return Vec2{std::round(1e6 * p.x) / 1e6, std::round(1e6 * p.y) / 1e6}; };
    begins.push_back(rounded(Vec2{0.5, 0.25} + static_cast<double>(i) * out));
    curves.push_back(polygon({begins.back(), rounded(begins.back() + 0.5 * out)}, false));
  }
  const SampledCurves samples = sampled_together(set_of(curves), {.rule = SamplingRule::adaptive, .count = 3000});
  for (const Vec2 begin : begins) {
    const auto at = std::ranges::find(samples.positions, begin);
    REQUIRE(at != samples.positions.end());
    const auto index = static_cast<std::uint32_t>(at - samples.positions.begin());
    std::size_t chains = 0;
    for (const SampledCurves::Chain& chain : samples.chains)
      chains += std::ranges::count(places_of(samples, chain), index) != 0 ? 1U : 0U;
    CHECK(chains == 2);
  }
}

TEST_CASE("contacts of nested and crossing outlines are found with little work, whatever their slants") {
  Rng rng(7);
  const auto nested = [&](std::size_t corners, double inner, double jitter, std::size_t count) {
    std::vector<PlaneCurve> out;
    for (std::size_t i = 0; i < count; ++i) {
      const double size = 1000.0 * (1.0 - 0.95 * static_cast<double>(i) / static_cast<double>(count));
      std::vector<Vec2> points;
      for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(corners) + 0.1;
        const double radius = size * (k % 2 == 0 ? 1.0 : inner) + jitter * rng.uniform(0.0, 1.0);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
      out.push_back(closed_polygon(points));
    }
    return out;
  };
  const auto woven = [](std::size_t count) {
    std::vector<PlaneCurve> out;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 0.5 * static_cast<double>(i);
      out.push_back(polygon({{x, 0.1}, {x + 300.2, 900.5}}, false));
      out.push_back(polygon({{x, 900.3}, {x + 300.7, 0.2}}, false));
    }
    return out;
  };
  const auto circles = [](std::size_t count) {
    std::vector<PlaneCurve> out;
    for (std::size_t i = 1; i <= count; ++i) out.push_back(circle_around({0.5, 0.25}, static_cast<double>(i)));
    return out;
  };
  const auto most = [](std::vector<PlaneCurve> curves) {
    Rng order(3);
    for (std::size_t i = curves.size(); i > 1; --i) std::swap(curves[i - 1], curves[order.below(i)]);
    const Contacts contacts = contacts_of(curves, 1e-6, false, nullptr);
    CHECK(contacts.contacts.empty());
    return static_cast<double>(contacts.work) / static_cast<double>(contacts.vertices.size());
  };
  for (const std::size_t count : {500U, 4000U}) {
    INFO(count << " of each");
    CHECK(most(nested(8, 1.0, 0.0, count)) < 260.0);
    CHECK(most(nested(8, 1.0, 0.1, count)) < 260.0);
    CHECK(most(nested(3, 1.0, 0.0, count)) < 260.0);
    CHECK(most(nested(14, 0.4, 0.0, count)) < 260.0);
    CHECK(most(nested(14, 0.4, 0.1, count)) < 260.0);
    CHECK(most(woven(count)) < 260.0);
    CHECK(most(circles(count)) < 260.0);
  }
}

TEST_CASE("contacts are the same however many outlines are nested around them") {
  Rng rng(11);
  const auto somewhere = [&] { return Vec2{rng.uniform(-10.0, 10.0), rng.uniform(-10.0, 10.0)}; };
  std::vector<PlaneCurve> curves;
  for (int i = 0; i < 60; ++i) {
    PlaneCurve curve(somewhere());
    const int kind = i % 4;
    if (kind == 0) curve.line_to(somewhere());
    if (kind == 1) curve.quadratic_to(somewhere(), somewhere());
    if (kind == 2) curve.cubic_to(somewhere(), somewhere(), somewhere());
    if (kind == 3) {
      const Vec2 to = somewhere();
      const double radius = distance(curve.start(), to) * rng.uniform(0.5, 3.0);
      const auto arc = arc_between(curve.start(), to, {radius, 0.7 * radius}, rng.uniform(0.0, 3.0),
                                   rng.below(2) == 0, rng.below(2) == 0);
      REQUIRE(arc.has_value());
      curve.arc_to(*arc, to);
    }
    const Piece piece = pieces_of(curve).front();
    curves.push_back(curve);
    for (int k = 0; k < 4; ++k) curves.push_back(polygon({piece.at(rng.uniform(0.05, 0.95)), somewhere()}, false));
  }
  // The extent decides what is rounding, so it is the same.
  const PlaneCurve frame = rectangle(-5000, -5000, 5000, 5000);
  curves.push_back(frame);
  const Contacts few = contacts_of(curves, 1e-7, false, nullptr);
  for (int i = 0; i < 1500; ++i) {
    const double r = 1000.0 + i;
    curves.push_back(closed_polygon({{r, 0}, {0, r}, {-r, 0}, {0, -r}}));
  }
  const Contacts many = contacts_of(curves, 1e-7, false, nullptr);
  CHECK(few.contacts.size() >= 240);
  REQUIRE(many.contacts.size() == few.contacts.size());
  for (std::size_t i = 0; i < few.contacts.size(); ++i) {
    CHECK(many.contacts[i].vertex == few.contacts[i].vertex);
    CHECK(many.contacts[i].piece == few.contacts[i].piece);
    CHECK(many.contacts[i].parameter == few.contacts[i].parameter);
  }
}

TEST_CASE("a curve that repeats another says nothing new, but one around the other way fills a hole") {
  const PlaneCurve outer = rectangle(0, 0, 10, 10);
  const PlaneCurve hole = closed_polygon({{2, 2}, {2, 8}, {8, 8}, {8, 2}});
  const PlaneCurve filling = closed_polygon({{8, 8}, {2, 8}, {2, 2}, {8, 2}});
  CHECK(sampled_together(set_of({outer, outer}), {.rule = SamplingRule::vertices}).chains.size() == 1);
  CHECK(sampled_together(set_of({outer, hole, filling}), {.rule = SamplingRule::vertices}).chains.size() == 3);
  CHECK(sampled_together(set_of({outer, hole, hole}), {.rule = SamplingRule::vertices}).chains.size() == 2);
}

TEST_CASE("a hole that touches its shell, at a corner and within a side") {
  const PlaneCurve shell = rectangle(0, 0, 10, 10);
  for (const PlaneCurve& hole :
       {closed_polygon({{0, 0}, {4, 2}, {2, 4}}), closed_polygon({{5, 0}, {6, 4}, {4, 4}})}) {
    const SampledCurves samples =
        sampled_together(set_of({shell, hole}), {.rule = SamplingRule::spacing, .spacing = 0.5});
    REQUIRE(samples.chains.size() == 2);
    const auto around = places_of(samples, samples.chains[0]);
    const auto inside = places_of(samples, samples.chains[1]);
    std::set<std::uint32_t> both;
    for (const std::uint32_t place : around)
      if (std::ranges::find(inside, place) != inside.end()) both.insert(place);
    REQUIRE(both.size() == 1);
    CHECK(samples.positions[*both.begin()] == hole.start());
  }
}

TEST_CASE("spikes of outlines are removed, at any place and in any direction, and nothing else is") {
  const std::vector<Vec2> ring{{0, 0}, {100, 0}, {100, 20}, {60, 20}, {60, 70}, {0, 20}};
  Rng rng(6);
  for (int round = 0; round < 200; ++round) {
    INFO("round " << round);
    const double angle = round % 4 == 0 ? 0.0 : rng.uniform(0.0, 6.0);
    std::vector<Vec2> points;
    for (const Vec2 p : ring)
      points.push_back(
          {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y});
    const std::vector<Vec2> plain = points;
    for (std::uint64_t spikes = 1 + rng.below(3); spikes > 0; --spikes) {
      // Past a vertex in the direction of the side before it, or anywhere; perhaps with a stop on the way, and bent.
      const std::size_t i = 1 + rng.below(points.size() - 1);
      const bool goes_on = rng.below(2) == 0;
      const Vec2 along = goes_on ? points[i] - points[i - 1] : Vec2{rng.uniform(-9, 9), rng.uniform(-9, 9)};
      const Vec2 at = points[i];
      std::vector<Vec2> spike{at + 0.4 * along};
      if (rng.below(2) == 0) spike.push_back(at + 0.2 * along);
      if (rng.below(2) == 0) spike.insert(spike.begin(), at + 0.1 * along);
      spike.push_back(at);
      const auto after =
          points.insert(points.begin() + static_cast<std::ptrdiff_t>(i + 1), spike.begin(), spike.end());
      if (goes_on && rng.below(2) == 0) points.erase(after - 1);  // the side runs past the vertex at once
    }
    std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(rng.below(points.size())));
    const bool repeats = rng.below(2) == 0;
    if (repeats) points.push_back(points.front());
    std::vector<Vec2> left = points;
    left.insert(left.begin(), {5, 5});
    remove_spikes(left, 1);
    CHECK(left.front() == Vec2{5, 5});
    left.erase(left.begin());
    if (repeats) {
      CHECK(left.front() == left.back());
      left.pop_back();
    }
    double area = 0.0;
    double around = 0.0;
    for (std::size_t k = 0; k < left.size(); ++k) {
      area += 0.5 * cross(left[k], left[(k + 1) % left.size()]);
      around += distance(left[k], left[(k + 1) % left.size()]);
    }
    CHECK(area == Approx(3500.0));
    CHECK(around == Approx(100.0 + 20.0 + 40.0 + 50.0 + 10.0 * std::sqrt(61.0) + 20.0));
    for (const Vec2 corner : plain)
      CHECK(std::ranges::any_of(left, [&](Vec2 p) { return distance(p, corner) < 1e-9; }));
  }
  for (const std::vector<Vec2>& kept : {ring, {{0, 0}, {4, 0}, {2, 0}}, {{0, 0}, {4, 0}}, {{1, 1}}, {}}) {
    std::vector<Vec2> points = kept;
    remove_spikes(points);
    CHECK(points == kept);
  }
}

TEST_CASE("an outline that goes to its hole along a slit and back is two, and a cut between two is none") {
  const PlaneCurve keyhole = closed_polygon(
      {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}, {3, 5}, {3, 7}, {7, 7}, {7, 3}, {3, 3}, {3, 5}, {0, 5}});
  const auto nowhere = [](Vec2) { return false; };
  const auto rings = without_cuts({keyhole}, 0.0, nowhere);
  REQUIRE(rings.size() == 2);
  CHECK(std::ranges::all_of(rings, &PlaneCurve::is_closed));
  double length = 0.0;
  for (const PlaneCurve& ring : rings)
    ring.for_each_piece([&](const Piece& piece) { length += distance(piece.from(), piece.to()); });
  CHECK(length == 56.0);

  const auto halves = std::vector{rectangle(0, 0, 4, 5), closed_polygon({{4, 1}, {9, 1}, {9, 5}, {4, 5}})};
  CHECK(without_cuts(halves, 0.0, nowhere) == halves);
  const auto whole = without_cuts(halves, 0.0, [](Vec2 p) { return p.x == 4.0; });
  REQUIRE(whole.size() == 1);
  CHECK(std::ranges::count(whole[0].points(), Vec2{4, 1}) >= 1);
  double around = 0.0;
  whole[0].for_each_piece([&](const Piece& piece) { around += distance(piece.from(), piece.to()); });
  CHECK(around == 28.0);
}

TEST_CASE("coordinates tell to how many decimals they were rounded") {
  CHECK(resolution_of(std::vector<Vec2>{{1, 2}, {-30, 400}}) == 1.0);
  CHECK(resolution_of(std::vector<Vec2>{{13.4567, 52.5}, {13.4568, 52.51}}) == Approx(1e-4));
  CHECK(resolution_of(std::vector<Vec2>{{5412345.123, 0.001}}) == Approx(1e-3));
  CHECK(resolution_of(std::vector<Vec2>{{std::sqrt(2.0), std::sqrt(3.0)}, {1.0, 1.0}}) == 0.0);
  CHECK(resolution_of(std::vector<Vec2>{{1e300, 1.0}}) == 0.0);
  CHECK(resolution_of({}) == 1.0);
}

TEST_CASE("between vertices that are far apart there are samples, and vertices stay") {
  // A corridor 60 long and 1 wide, and a house of another scale beside it.
  const CurveSet curves = set_of({rectangle(0, 0, 60, 1), rectangle(70, 0, 70.2, 0.1)});
  const SamplingRequest request = default_sampling(curves);
  CHECK(request.rule == SamplingRule::refined);
  const SampledCurves samples = sampled_together(curves, request);
  for (const PlaneCurve& curve : curves.curves)
    for (const Vec2 corner : curve.points())
      CHECK(std::ranges::find(samples.positions, corner) != samples.positions.end());
  const std::map<Link, int> links = links_of(samples);
  for (const auto& [link, times] : links) {
    const Vec2 a = samples.positions[link.first];
    const double gap = distance(a, samples.positions[link.second]);
    CHECK(gap <= (a.x < 65.0 ? 0.41 : 0.041));
  }
  // A coast is dense enough as it is.
  std::vector<Vec2> coast;
  for (int i = 0; i < 1000; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 1000.0;
    coast.push_back({(10.0 + std::cos(5.0 * t)) * std::cos(t), (10.0 + std::cos(5.0 * t)) * std::sin(t)});
  }
  const CurveSet round{.curves = {closed_polygon(coast)}};
  CHECK(sampled_together(round, default_sampling(round)).positions == coast);
}

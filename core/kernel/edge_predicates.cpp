// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/edge_predicates.h"

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/base/power_of_two.h"
#include "core/kernel/numbers/two_doubles.h"

namespace mes {
namespace {

using Interval = CGAL::Interval_nt<false>;
using Integer = CGAL::Mpzf;  ///< integers times powers of two: a ring that holds the doubles, quicker than fractions

template <class Number>
struct GeneralPhase {
  Number h, i;
};

// Evaluates the polynomials of `phase_of` in any ring.
template <class Number>
GeneralPhase<Number> phase_in(const EdgeCorners& e) {
  const auto number = [](double x) { return Number(x); };
  const Number qx = number(e.q.x), qy = number(e.q.y), rx = number(e.r.x), ry = number(e.r.y);
  const auto apex = [&](Vec2 a, bool left) -> GeneralPhase<Number> {
    const Number ax = number(a.x), ay = number(a.y);
    const Number ux = (left ? qx : rx) - ax, uy = (left ? qy : ry) - ay;
    const Number vx = (left ? rx : qx) - ax, vy = (left ? ry : qy) - ay;
    return {ux * vx + uy * vy, ux * vy - uy * vx};
  };
  GeneralPhase<Number> p = apex(e.p, true);
  if (!e.s) return p;
  const GeneralPhase<Number> s = apex(*e.s, false);
  return {p.h * s.h - p.i * s.i, p.i * s.h + p.h * s.i};
}

double largest_difference(const EdgeCorners& e) {
  const auto size = [](Vec2 a, Vec2 b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); };
  const double m = std::max(size(e.q, e.p), size(e.r, e.p));
  return e.s ? std::max({m, size(e.r, *e.s), size(e.q, *e.s)}) : m;
}

// True for points on a grid whose step is not much smaller than the edge, such as pixel corners and other integers.
// Differences are then at most 2^12 grid steps, H and I at most 2^51, and doubles evaluate both without rounding. Ties
// are the rule on such inputs, so it pays to decide them here.
bool is_on_coarse_grid(const EdgeCorners& e, double largest) {
  const double steps = std::ldexp(1.0, 11 - std::ilogb(largest));
  const auto is_whole = [steps](double x) {
    const double scaled = x * steps;
    return scaled == std::trunc(scaled) && (scaled != 0.0 || x == 0.0);
  };
  const auto is_on_grid = [&](Vec2 a) { return is_whole(a.x) && is_whole(a.y); };
  return is_on_grid(e.p) && is_on_grid(e.q) && is_on_grid(e.r) && (!e.s || is_on_grid(*e.s));
}

EdgeClass classify_slowly(const EdgeCorners& corners, FilterCounts& counts) {
  {
    CGAL::Protect_FPU_rounding<true> rounding;
    const GeneralPhase<Interval> phase = phase_in<Interval>(corners);
    const bool h_known = phase.h.inf() > 0.0 || phase.h.sup() < 0.0;
    const bool i_known = !corners.s || phase.i.inf() > 0.0 || phase.i.sup() < 0.0;
    if (h_known && i_known) {
      ++counts.interval;
      return {phase.h.inf() > 0.0, false};
    }
  }
  ++counts.exact;
  const GeneralPhase<Integer> phase = phase_in<Integer>(corners);
  return {CGAL::sign(phase.h) != CGAL::NEGATIVE, corners.s && CGAL::is_zero(phase.i)};
}

}  // namespace

EdgeClass classify_edge(const EdgeCorners& corners, FilterCounts& counts) {
  // Forward error analysis of the double evaluation gives 80.1 u M^4 for H (u = 2^-53, M = largest coordinate
  // difference), the same for I; 96 leaves room for the rounding of the bound itself. The degree-2 hull case needs
  // less than 8 u M^2. Between 1e-70 and 1e70 neither M^4 nor its error term leaves the normal range.
  constexpr double kUnit = 0x1p-53;
  const double m = largest_difference(corners);
  if (m > 1e-70 && m < 1e70) {
    const Phase phase = phase_of(corners);
    const double m2 = m * m;
    const double bound = corners.s ? 96.0 * kUnit * m2 * m2 : 8.0 * kUnit * m2;
    if (std::abs(phase.h) > bound && (!corners.s || std::abs(phase.i) > bound)) {
      ++counts.static_filter;
      return {phase.h > 0.0, false};
    }
    if (is_on_coarse_grid(corners, m)) {
      ++counts.static_filter;
      return {phase.h >= 0.0, corners.s && phase.i == 0.0};
    }
  }
  return classify_slowly(corners, counts);
}

namespace {

// The difference of two points times a power of two that brings it to about unit size.
Vec2 direction_between(Vec2 from, Vec2 to) {
  Vec2 d = to - from;
  if (!is_finite(d)) d = 0.5 * to - 0.5 * from;
  const double size = std::max(std::abs(d.x), std::abs(d.y));
  if (size == 0.0) return d;
  const int exponent = std::ilogb(size);
  return {times_power_of_two(d.x, -exponent), times_power_of_two(d.y, -exponent)};
}

// A positive multiple of the phase, whatever the sizes. Where a product may have left the range of doubles, each leg of
// the two angles is scaled to about unit size, which changes no angle.
Phase angle_of(const EdgeCorners& e) {
  const double m = largest_difference(e);
  // Within the range of coordinates differences are at least 2^-154 of the largest: no product of four of them leaves
  // the normal range, and the last bit is the same at every scale.
  if (m > 0x1p-60 && m < 0x1p60) {
    const Phase phase = phase_of(e);
    // For differences outside that range, too, products have then lost at most 1e-30 of the whole.
    if (std::abs(phase.h) > 1e-150 || std::abs(phase.i) > 1e-150) return phase;
  }
  const Vec2 pq = direction_between(e.p, e.q);
  const Vec2 pr = direction_between(e.p, e.r);
  const Phase p{dot(pq, pr), cross(pq, pr)};
  if (!e.s) return p;
  const Vec2 sr = direction_between(*e.s, e.r);
  const Vec2 sq = direction_between(*e.s, e.q);
  const Phase s{dot(sr, sq), cross(sr, sq)};
  return {p.h * s.h - p.i * s.i, p.i * s.h + p.h * s.i};
}

}  // namespace

double edge_confidence(const EdgeCorners& corners) {
  const Phase phase = angle_of(corners);
  const double size = length({phase.h, phase.i});
  return size > 0.0 ? phase.h / size : 0.0;
}

double ambiguity_key(const EdgeCorners& corners) {
  const Phase phase = angle_of(corners);
  const double squared = phase.h * phase.h + phase.i * phase.i;
  const double size = squared > 0x1p-900 && squared < 0x1p1000 ? std::sqrt(squared) : length({phase.h, phase.i});
  if (!(size > 0.0)) return 0.0;
  // The key is |cos| where it varies and, near 1, where |cos| is flat, a constant less the sine. Both are within some
  // 40 u of their true values, since D and X carry errors of a few u times the lengths of their factors.
  const bool is_flat = std::abs(phase.h) > std::abs(phase.i);
  const double smaller = std::abs(is_flat ? phase.i : phase.h) / size;
  return is_flat ? 1.41421356237309505 - smaller : smaller;
}

namespace {

// |cot(alpha + beta)|, infinite where `under` is 0.
template <class Number>
struct Cotangent {
  Number over, under;
};

TwoDoubles absolute(const TwoDoubles& number) {
  return number.value() < 0.0 ? -number : number;
}
Integer absolute(const Integer& number) {
  return CGAL::abs(number);
}
int sign_of(const TwoDoubles& number) {
  return number.sign();
}
int sign_of(const Integer& number) {
  return CGAL::sign(number);
}

template <class Number>
Cotangent<Number> cotangent_in(const EdgeCorners& e) {
  const GeneralPhase<Number> phase = phase_in<Number>(e);
  return {absolute(phase.h), phase.i};
}

// -1, 0 or 1; in `TwoDoubles`, 0 means not known.
template <class Number>
int compare_cotangents(const Cotangent<Number>& a, const Cotangent<Number>& b) {
  return sign_of(a.over * b.under - b.over * a.under);
}

// Exact for numbers of at most 51 bits, since two doubles hold the product of two of them.
int compare_cotangents(const Cotangent<double>& a, const Cotangent<double>& b) {
  const double left = a.over * b.under;
  const double right = b.over * a.under;
  if (left != right) return left < right ? -1 : 1;
  const double left_rest = std::fma(a.over, b.under, -left);
  const double right_rest = std::fma(b.over, a.under, -right);
  return left_rest < right_rest ? -1 : (right_rest < left_rest ? 1 : 0);
}

// Exact; nothing unless the corners lie on a coarse grid.
std::optional<Cotangent<double>> cotangent_on_grid(const EdgeCorners& e) {
  const double size = largest_difference(e);
  if (!(size > 1e-30 && size < 1e30 && is_on_coarse_grid(e, size))) return std::nullopt;
  const Phase phase = phase_of(e);
  return Cotangent<double>{std::abs(phase.h), phase.i};
}

// The square of |ab|.
template <class Number>
Number square_in(Vec2 a, Vec2 b) {
  const Number x = Number(b.x) - Number(a.x);
  const Number y = Number(b.y) - Number(a.y);
  return x * x + y * y;
}

}  // namespace

int compare_ambiguity(const EdgeCorners& a, const EdgeCorners& b) {
  if (const auto of_a = cotangent_on_grid(a))
    if (const auto of_b = cotangent_on_grid(b)) return compare_cotangents(*of_a, *of_b);
  const int order = compare_cotangents(cotangent_in<TwoDoubles>(a), cotangent_in<TwoDoubles>(b));
  return order != 0 ? order : compare_cotangents(cotangent_in<Integer>(a), cotangent_in<Integer>(b));
}

std::vector<std::uint32_t> ambiguity_places(std::span<const EdgeCorners> edges,
                                            const std::function<void()>& checkpoint) {
  constexpr std::size_t kBetweenLooks = 4096;
  std::size_t looks = 0;
  const auto look = [&] {
    if (looks++ % kBetweenLooks == 0) checkpoint();
  };
  std::vector<std::optional<Cotangent<double>>> on_grid;
  std::vector<TwoDoubles> rounded;
  on_grid.reserve(edges.size());
  rounded.reserve(edges.size());
  for (const EdgeCorners& edge : edges) {
    look();
    on_grid.push_back(cotangent_on_grid(edge));
    const Cotangent<TwoDoubles> cotangent = cotangent_in<TwoDoubles>(edge);
    rounded.push_back(cotangent.over / cotangent.under);
  }
  std::vector<std::unique_ptr<const Cotangent<Integer>>> exact(edges.size());
  const auto exactly = [&](std::uint32_t i) -> const Cotangent<Integer>& {
    if (exact[i] == nullptr) exact[i] = std::make_unique<const Cotangent<Integer>>(cotangent_in<Integer>(edges[i]));
    return *exact[i];
  };
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    look();
    if (on_grid[a] && on_grid[b]) return compare_cotangents(*on_grid[a], *on_grid[b]) < 0;
    const int order = (rounded[a] - rounded[b]).sign();
    return (order != 0 ? order : compare_cotangents(exactly(a), exactly(b))) < 0;
  };
  std::vector<std::uint32_t> order(edges.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, is_before);
  std::vector<std::uint32_t> out(edges.size());
  std::uint32_t place = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && is_before(order[i - 1], order[i])) ++place;
    out[order[i]] = place;
  }
  return out;
}

int compare_lengths(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 u = b - a;
  const Vec2 v = d - c;
  const double left = dot(u, u);
  const double right = dot(v, v);
  const double size = std::max(left, right);
  // Each side is within 4 u of its true value unless it under- or overflows.
  if (size > 1e-280 && size < 1e300 && std::abs(left - right) > 0x1p-49 * size) return left < right ? -1 : 1;
  const int order = (square_in<TwoDoubles>(a, b) - square_in<TwoDoubles>(c, d)).sign();
  return order != 0 ? order : CGAL::sign(square_in<Integer>(a, b) - square_in<Integer>(c, d));
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/growth/radical_axis.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/kernel/rounding.h"
#include "core/structures/balls/internal/numbers/union_numbers.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<false>;

constexpr double kTolerance = 0x1p-36;

/// The terms that define the axis, without roots.
template <class Number>
struct AxisTerms {
  Number x, y;         ///< vector from the first centre to the second
  Number dd;           ///< its squared length
  Number first, last;  ///< twice a foot, times the distance
  Number power;
};
template <class Number>
AxisTerms<Number> axis_terms(const BallOf<Number>& a, const BallOf<Number>& b) {
  AxisTerms<Number> out;
  out.x = b.x - a.x;
  out.y = b.y - a.y;
  out.dd = out.x * out.x + out.y * out.y;
  const Number more = a.w - b.w;
  out.first = out.dd + more;
  out.last = out.dd - more;
  // Starts from the smaller ball, so that the subtraction at the end loses least.
  const bool is_first = !(CGAL::to_double(more) > 0.0);
  const Number& twice = is_first ? out.first : out.last;
  out.power = twice * twice / (Number(4) * out.dd) - (is_first ? a.w : b.w);
  return out;
}

double middle(const Interval& x) {
  return 0.5 * x.inf() + 0.5 * x.sup();
}
/// Bounds how far any number of the interval is from its middle.
double width(const Interval& x) {
  return x.sup() - x.inf();
}

struct Rounded {
  double value, error;
};
RadicalAxis axis_of(Vec2 way, double first, double last, Rounded power, double smaller_radius) {
  RadicalAxis out;
  const double apart = std::hypot(way.x, way.y);
  out.direction = {way.x / apart, way.y / apart};
  out.foot = {0.5 * (first / apart), 0.5 * (last / apart)};
  out.power = power.value;
  out.power_error = power.error;
  out.tolerance = kTolerance * std::max(smaller_radius, std::min(std::abs(out.foot[0]), std::abs(out.foot[1])));
  return out;
}

bool is_within(double power_error, double half, double tolerance) {
  return power_error <= 2.0 * tolerance * half;
}

AxisTerms<Interval> interval_terms(const BallOf<Interval>& a, const BallOf<Interval>& b) {
  const CGAL::Protect_FPU_rounding<true> rounding;
  return axis_terms(a, b);
}

/// Returns nothing if intervals are too wide.
std::optional<RadicalAxis> quick_axis(const BallOf<Interval>& a, const BallOf<Interval>& b) {
  // Drawn positions are rounded to nearest, as with exact numbers.
  const AxisTerms<Interval> terms = interval_terms(a, b);
  const double radius = std::sqrt(std::max(0.0, std::min(a.w.inf(), b.w.inf())));
  const Vec2 way{middle(terms.x), middle(terms.y)};
  const RadicalAxis out =
      axis_of(way, middle(terms.first), middle(terms.last), {middle(terms.power), width(terms.power)}, radius);
  const double apart = std::hypot(way.x, way.y);
  const double skew = (width(terms.x) + width(terms.y)) / apart;
  const double reach = std::max({radius, std::abs(out.foot[0]), std::abs(out.foot[1])});
  const double slip = 0.5 * std::max(width(terms.first), width(terms.last)) / apart;
  // The crossing turns with the direction about the centre it is seen from, and moves with the foot.
  const bool is_good = skew <= kTolerance && skew * reach + slip <= out.tolerance && std::isfinite(out.power_error) &&
                       (out.power >= 0.0 || is_within(out.power_error, std::sqrt(-out.power), out.tolerance));
  return is_good ? std::optional(out) : std::nullopt;
}

RadicalAxis exact_axis(const PipelineBall& first, const PipelineBall& second) {
  const BallOf<Rational> a = ball_in<Rational>(first);
  const BallOf<Rational> b = ball_in<Rational>(second);
  const AxisTerms<Rational> exact = axis_terms(a, b);
  const double power = rounded(exact.power);
  const double error = Rational(power) == exact.power ? 0.0 : 0x1p-53 * std::abs(power);
  return axis_of({rounded(exact.x), rounded(exact.y)}, rounded(exact.first), rounded(exact.last), {power, error},
                 std::min(first.radius(), second.radius()));
}

RadicalAxis turned(RadicalAxis axis) {
  axis.direction = -axis.direction;
  std::swap(axis.foot[0], axis.foot[1]);
  return axis;
}

}  // namespace

std::vector<RadicalAxis> radical_axes(const PipelineInput& input, std::span<const BallPair> pairs, JobControl& job) {
  std::vector<RadicalAxis> out(pairs.size());
  Table<InputSlot, BallOf<Interval>> ball(input.balls.size());
  std::vector<std::size_t> left;
  {
    const CGAL::Protect_FPU_rounding<true> rounding;
    for (const InputSlot i : ball.rows()) ball[i] = ball_in<Interval>(input.balls[i]);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = std::minmax(pairs[i][0], pairs[i][1]);
    if (const auto axis = quick_axis(ball[a], ball[b])) {
      out[i] = pairs[i][0] == a ? *axis : turned(*axis);
    } else {
      left.push_back(i);
    }
  }
  for (const std::size_t i : left) {
    if (i % 64 == 0) job.checkpoint();
    const auto [a, b] = std::minmax(pairs[i][0], pairs[i][1]);
    const RadicalAxis axis = exact_axis(input.balls[a], input.balls[b]);
    out[i] = pairs[i][0] == a ? axis : turned(axis);
  }
  return out;
}

double half_chord(const PipelineInput& input, const BallPair& pair, const RadicalAxis& axis, double growth) {
  const double a = input.frame.to_local_length(growth);
  if (a > 0x1p500) return a;
  const double square = std::fma(a, a, -axis.power);
  const double half = std::sqrt(std::max(0.0, square));
  if (is_within(axis.power_error, half, axis.tolerance)) return half;
  const Rational grown = Rational(growth) / Rational(std::ldexp(1.0, input.frame.exponent));
  const auto [first, second] = std::minmax(pair[0], pair[1]);
  const Rational power =
      axis_terms(ball_in<Rational>(input.balls[first]), ball_in<Rational>(input.balls[second])).power;
  return std::sqrt(std::max(0.0, rounded(Rational(grown * grown - power))));
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/interpolation/b_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mes {
namespace {

constexpr std::size_t kHighestDegree = 15;

/// A weighted point in homogeneous coordinates, in which rational splines are polynomial.
struct Weighted {
  Vec2 p;
  double w = 1.0;
};
Weighted weighted_between(const Weighted& a, const Weighted& b, double t) {
  return {(1.0 - t) * a.p + t * b.p, (1.0 - t) * a.w + t * b.w};
}

struct Jet {
  Vec2 place;
  Vec2 derivative;
};

bool is_spline(const BSpline& spline) {
  const std::size_t count = spline.controls.size();
  if (spline.degree == 0 || spline.degree > kHighestDegree || count <= spline.degree) return false;
  if (spline.knots.size() != count + spline.degree + 1) return false;
  if (!spline.weights.empty() && spline.weights.size() != count) return false;
  return std::ranges::all_of(spline.knots, [](double knot) { return std::isfinite(knot); }) &&
         std::ranges::is_sorted(spline.knots) &&
         std::ranges::all_of(spline.weights, [](double w) { return w > 0.0 && std::isfinite(w); }) &&
         std::ranges::all_of(spline.controls, [](Vec2 p) { return is_finite(p); });
}

bool is_rational(const BSpline& spline) {
  return std::ranges::any_of(spline.weights, [&](double w) { return w != spline.weights.front(); });
}

/// Merges knots that only rounding separates.
void settle_knots(std::vector<double>& knots) {
  constexpr double kEqual = 1e-10;
  constexpr double kRounding = 1e-6;
  const double range = knots.back() - knots.front();
  if (!(range > 0.0)) return;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double step = knots[i] - knots[i - 1];
    if (step < kEqual * range && step > -kRounding * range) knots[i] = knots[i - 1];
  }
}

/// Removes control points that no point of the spline depends on, each with one of the knots that repeat more than
/// `degree` + 1 times.
void drop_idle_controls(BSpline& spline) {
  BSpline kept{.degree = spline.degree};
  const std::size_t count = spline.controls.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (spline.knots[i] == spline.knots[i + spline.degree + 1]) continue;
    kept.knots.push_back(spline.knots[i]);
    kept.controls.push_back(spline.controls[i]);
    if (!spline.weights.empty()) kept.weights.push_back(spline.weights[i]);
  }
  if (kept.controls.size() == count) return;
  for (std::size_t i = count; i < spline.knots.size(); ++i) kept.knots.push_back(spline.knots[i]);
  spline = std::move(kept);
}

/// De Boor's algorithm in the span that starts at knot `span`, including both of its ends.
Jet jet_at(const BSpline& spline, std::size_t span, double t) {
  const std::size_t degree = spline.degree;
  std::array<Weighted, kHighestDegree + 1> d;
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t i = span - degree + j;
    const double w = spline.weights.empty() ? 1.0 : spline.weights[i] / spline.weights[0];
    d[j] = {w * spline.controls[i], w};
  }
  Weighted slope{{}, 0.0};
  for (std::size_t round = 1; round <= degree; ++round) {
    if (round == degree) {
      const double width = spline.knots[span + 1] - spline.knots[span];
      const double scale = static_cast<double>(degree) / width;
      slope = {scale * (d[degree].p - d[degree - 1].p), scale * (d[degree].w - d[degree - 1].w)};
    }
    for (std::size_t j = degree; j >= round; --j) {
      const double low = spline.knots[span - degree + j];
      const double high = spline.knots[span + 1 + j - round];
      d[j] = weighted_between(d[j - 1], d[j], (t - low) / (high - low));
    }
  }
  const Vec2 place = (1.0 / d[degree].w) * d[degree].p;
  return {place, (1.0 / d[degree].w) * (slope.p - slope.w * place)};
}

}  // namespace

BSpline BSpline::clamped(std::size_t degree, std::vector<Vec2> controls) {
  BSpline out{.degree = degree, .controls = std::move(controls)};
  if (out.controls.size() <= degree) return out;
  const std::size_t spans = out.controls.size() - degree;
  for (std::size_t i = 0; i < degree; ++i) out.knots.push_back(0.0);
  for (std::size_t i = 0; i <= spans; ++i) out.knots.push_back(static_cast<double>(i));
  for (std::size_t i = 0; i < degree; ++i) out.knots.push_back(static_cast<double>(spans));
  return out;
}

BSpline BSpline::closed(std::size_t degree, const std::vector<Vec2>& controls) {
  BSpline out{.degree = degree, .controls = controls};
  if (controls.empty()) return out;
  for (std::size_t i = 0; i < degree; ++i) out.controls.push_back(controls[i % controls.size()]);
  for (std::size_t i = 0; i < out.controls.size() + degree + 1; ++i) out.knots.push_back(static_cast<double>(i));
  return out;
}

std::vector<PlaneCurve> curves_of_spline(BSpline spline) {
  if (!spline.knots.empty()) settle_knots(spline.knots);
  if (!is_spline(spline)) return {};
  drop_idle_controls(spline);
  constexpr std::size_t kCubic = 3;
  constexpr int kPieces = 32;
  const int pieces = is_rational(spline) || spline.degree > kCubic ? kPieces : 1;
  // Points that differ only by rounding become equal: the end and the start of the curve, and both sides of a knot.
  constexpr double kRounding = 1e-12;
  double size = 0.0;
  for (const Vec2 p : spline.controls) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  std::vector<PlaneCurve> out;
  for (std::size_t span = spline.degree; span < spline.controls.size(); ++span) {
    const double low = spline.knots[span];
    const double high = spline.knots[span + 1];
    if (!(low < high)) continue;
    Jet from = jet_at(spline, span, low);
    if (out.empty() || distance(from.place, out.back().end()) > kRounding * size) out.emplace_back(from.place);
    from.place = out.back().end();
    for (int i = 1; i <= pieces; ++i) {
      Jet to = jet_at(spline, span, i == pieces ? high : low + (high - low) * i / pieces);
      const bool is_end = i == pieces && high == spline.knots[spline.controls.size()];
      if (is_end && distance(to.place, out.back().start()) <= kRounding * size) to.place = out.back().start();
      const double third = (high - low) / (3.0 * pieces);
      if (!is_finite(to.place) || !is_finite(to.derivative) || !is_finite(from.derivative)) return {};
      if (spline.degree == 1 && pieces == 1) {
        out.back().line_to(to.place);
      } else {
        out.back().cubic_to(from.place + third * from.derivative, to.place - third * to.derivative, to.place);
      }
      from = to;
    }
  }
  return out;
}

std::optional<PlaneCurve> curve_of_spline(BSpline spline) {
  std::vector<PlaneCurve> curves = curves_of_spline(std::move(spline));
  if (curves.size() != 1) return std::nullopt;
  return std::move(curves.front());
}

}  // namespace mes

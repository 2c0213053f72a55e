// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/bezier_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figure/internal/grid.h"

namespace mes::figure {
namespace {

std::vector<Bezier> curves(Vec2 center, double radius, double first, double sweep, int decimals) {
  // A curve for a quarter of a circle is off by at most 2.73e-4 of the radius; for smaller angles the error falls with
  // their sixth power (Goldapp, "Approximation of circular arcs by cubic polynomials", 1991).
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  constexpr double kOff = 2.73e-4;
  const double allowed = 0.5 / power_of_ten(decimals);
  const double longest = kQuarter * std::min(1.0, std::pow(allowed / std::max(kOff * radius, allowed), 1.0 / 6.0));
  const auto count = static_cast<int>(std::ceil(sweep / longest - 1e-9));
  const double step = sweep / std::max(count, 1);
  const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * radius;
  std::vector<Bezier> out;
  for (int i = 0; i < std::max(count, 1); ++i) {
    const double from = first + step * i;
    const double to = first + step * (i + 1);
    const auto at = [&](double angle) { return center + radius * Vec2{std::cos(angle), -std::sin(angle)}; };
    const auto forward = [](double angle) { return Vec2{-std::sin(angle), -std::cos(angle)}; };
    out.push_back({at(from) + handle * forward(from), at(to) - handle * forward(to), at(to)});
  }
  return out;
}

}  // namespace

std::vector<Bezier> arc_curves(const Shape& arc, int decimals) {
  const Vec2 center = arc.p[2];
  const double first = std::atan2(center.y - arc.p[0].y, arc.p[0].x - center.x);
  std::vector<Bezier> out = curves(center, arc.radius, first, arc.sweep, decimals);
  out.back().end = arc.p[1];
  return out;
}

Bezier parabola_curve(const Shape& parabola) {
  const Vec2 from = parabola.p[0];
  const Vec2 to = parabola.p[1];
  const Vec2 control = parabola.p[2];
  return {from + 2.0 / 3.0 * (control - from), to + 2.0 / 3.0 * (control - to), to};
}

std::vector<Bezier> circle_curves(const Shape& circle, int decimals) {
  return curves(circle.p[0], circle.radius, 0.0, 2.0 * std::numbers::pi, decimals);
}

}  // namespace mes::figure

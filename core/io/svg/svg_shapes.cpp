// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_shapes.h"

#include <algorithm>
#include <numbers>

namespace mes {
namespace {

constexpr double kPi = std::numbers::pi;

/// A clockwise quarter turn on screen: from x towards y.
void add_quarter(PlaneCurve& curve, Vec2 center, Vec2 radii, double start, Vec2 to) {
  curve.arc_to({center, {radii.x, 0.0}, {0.0, radii.y}, start, 0.5 * kPi}, to);
}

}  // namespace

std::optional<PlaneCurve> svg_rect(Vec2 corner, Vec2 size, Vec2 radii) {
  if (!(size.x > 0.0) || !(size.y > 0.0)) return std::nullopt;
  const Vec2 r{std::clamp(radii.x, 0.0, 0.5 * size.x), std::clamp(radii.y, 0.0, 0.5 * size.y)};
  const Vec2 far = corner + size;
  if (r.x == 0.0 || r.y == 0.0) {
    PlaneCurve curve(corner);
    curve.line_to({far.x, corner.y});
    curve.line_to(far);
    curve.line_to({corner.x, far.y});
    curve.close();
    return curve;
  }
  PlaneCurve curve({corner.x + r.x, corner.y});
  curve.line_to({far.x - r.x, corner.y});
  add_quarter(curve, {far.x - r.x, corner.y + r.y}, r, -0.5 * kPi, {far.x, corner.y + r.y});
  curve.line_to({far.x, far.y - r.y});
  add_quarter(curve, {far.x - r.x, far.y - r.y}, r, 0.0, {far.x - r.x, far.y});
  curve.line_to({corner.x + r.x, far.y});
  add_quarter(curve, {corner.x + r.x, far.y - r.y}, r, 0.5 * kPi, {corner.x, far.y - r.y});
  curve.line_to({corner.x, corner.y + r.y});
  add_quarter(curve, {corner.x + r.x, corner.y + r.y}, r, kPi, curve.start());
  curve.close();
  return curve;
}

std::optional<PlaneCurve> svg_ellipse(Vec2 center, Vec2 radii) {
  if (!(radii.x > 0.0) || !(radii.y > 0.0)) return std::nullopt;
  PlaneCurve curve({center.x + radii.x, center.y});
  curve.arc_to({center, {radii.x, 0.0}, {0.0, radii.y}, 0.0, 2.0 * kPi}, curve.start());
  curve.close();
  return curve;
}

}  // namespace mes

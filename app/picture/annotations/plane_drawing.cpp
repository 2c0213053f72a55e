// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/annotations/plane_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/geometry/turn.h"

namespace mes {
namespace {

// Larger circles are drawn as chains of visible chords; kFlat: the largest distance of a chord from the circle.
constexpr double kLargest = 50'000.0;
constexpr double kFlat = 0.1;

}  // namespace

PlaneDrawing::PlaneDrawing(PaperDrawing& drawing, const SeenPlane& plane) : drawing_(drawing), plane_(plane) {
  const double margin = plane.width + plane.height;
  reach_.add(Vec2{-margin, -margin});
  reach_.add(Vec2{plane.width + margin, plane.height + margin});
}

Vec2 PlaneDrawing::on_paper(Vec2 world) const {
  const Vec2 from_center = (1.0 / plane_.units_per_pixel) * (world - plane_.center);
  return {0.5 * plane_.width + from_center.x, 0.5 * plane_.height - from_center.y};
}

bool PlaneDrawing::reaches(Vec2 p) const {
  return reach_.low.x <= p.x && p.x <= reach_.high.x && reach_.low.y <= p.y && p.y <= reach_.high.y;
}

// Clips the line (Liang and Barsky, 1984).
void PlaneDrawing::line(Vec2 at, Vec2 way, double low, double high, double width, Rgb color) {
  if (way == Vec2{} || !is_finite(at) || !is_finite(way)) return;
  const auto cut = [&](double against, double room) {
    if (against == 0.0) return room >= 0.0;
    const double t = room / against;
    if (against < 0.0)
      low = std::max(low, t);
    else
      high = std::min(high, t);
    return low <= high;
  };
  if (!cut(-way.x, at.x - reach_.low.x) || !cut(way.x, reach_.high.x - at.x) || !cut(-way.y, at.y - reach_.low.y) ||
      !cut(way.y, reach_.high.y - at.y))
    return;
  drawing_.strokes.push_back({{at + low * way, at + high * way}, width, color});
}

void PlaneDrawing::circle(Vec2 center, double radius, double width, Rgb color) {
  arc(center, radius, 0.0, kTurn, width, color);
}

void PlaneDrawing::arc(Vec2 center, double radius, double from, double sweep, double width, Rgb color) {
  if (!is_finite(center) || !std::isfinite(radius) || !(sweep > 0.0)) return;
  if (radius <= kLargest && reaches(center)) {
    drawing_.arcs.push_back({center, radius, from, sweep, width, color});
    return;
  }
  // Draws the part of the circle towards the middle of the drawing.
  const Vec2 middle{0.5 * plane_.width, 0.5 * plane_.height};
  const double toward = std::atan2(middle.y - center.y, middle.x - center.x);
  const double half = std::min(0.5 * kTurn, 2.0 * std::asin(std::min(1.0, (plane_.width + plane_.height) / radius)));
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kFlat / radius));
  if (!(step > 0.0)) return;
  const int count = std::clamp(static_cast<int>(std::ceil(2.0 * half / step)), 1, 2000);
  PaperDrawing::Stroke stroke{{}, width, color};
  const auto end_stroke = [&] {
    if (stroke.points.size() > 1) drawing_.strokes.push_back(stroke);
    stroke.points.clear();
  };
  for (int i = 0; i <= count; ++i) {
    const double angle = toward - half + 2.0 * half * i / count;
    const Vec2 p = center + radius * Vec2{std::cos(angle), std::sin(angle)};
    double after = std::fmod(angle - from, kTurn);
    if (after < 0.0) after += kTurn;
    if (after <= sweep && reaches(p))
      stroke.points.push_back(p);
    else
      end_stroke();
  }
  end_stroke();
}

}  // namespace mes

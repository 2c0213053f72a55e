// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/shape_pen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/draw/primitive_values.h"

namespace mes {
namespace {

// ImGui draws circles as polygons with corners all around; far too large ones are left out.
constexpr double kLargestPenCirclePx = 2.0e4;

/// The part of a + t d, low <= t <= high, within the rectangle from (0, 0) to `size`, enlarged by a margin.
struct PenPiece {
  Vec2 a, b;
};
std::optional<PenPiece> clipped(Vec2 a, Vec2 d, double low, double high, Vec2 size) {
  constexpr double kMargin = 20.0;
  const auto cut = [&](double from, double along, double least, double most) {
    if (along == 0.0) return from >= least && from <= most;
    const double t = (least - from) / along;
    const double u = (most - from) / along;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
    return low <= high;
  };
  if (!cut(a.x, d.x, -kMargin, size.x + kMargin) || !cut(a.y, d.y, -kMargin, size.y + kMargin)) return std::nullopt;
  return PenPiece{a + low * d, a + high * d};
}

ImVec2 to_im(Vec2 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

void stroke(ImDrawList& list, const std::optional<PenPiece>& piece, const PenLook& look) {
  if (piece) list.AddLine(to_im(piece->a), to_im(piece->b), look.color, look.width);
}

}  // namespace

ShapePen::ShapePen(const Gui& gui, const PanePart& pane, double content_scale, const PenLook& look)
    : camera_(pane.camera),
      shift_{static_cast<double>(pane.shift.x), static_cast<double>(pane.shift.y)},
      unit_(gui.unit()),
      to_screen_(static_cast<double>(gui.unit()) / content_scale),
      look_(look),
      size_{static_cast<double>(ImGui::GetIO().DisplaySize.x), static_cast<double>(ImGui::GetIO().DisplaySize.y)},
      list_(*ImGui::GetBackgroundDrawList()) {}

void ShapePen::draw(const ProvenanceShape& shape) const {
  const auto& v = shape.values;
  const Vec2 a{v[0], v[1]};
  switch (shape.kind) {
    case PrimitiveKind::point: return point(a);
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: return circle(a, v[2]);
    case PrimitiveKind::arc: return arc({a, v[2], {v[3], v[4]}, {v[5], v[6]}});
    case PrimitiveKind::parabola: return parabola(parabola_of(v.data()));
    case PrimitiveKind::segment: return line(a, {v[2], v[3]});
    case PrimitiveKind::ray: return unbounded(a, {v[2], v[3]}, 0.0);
    case PrimitiveKind::line: return unbounded(a, {v[2], v[3]}, -std::numeric_limits<double>::infinity());
    case PrimitiveKind::triangle:
      line(a, {v[2], v[3]});
      line({v[2], v[3]}, {v[4], v[5]});
      line({v[4], v[5]}, a);
      return;
  }
}

Vec2 ShapePen::on_screen(Vec2 world) const {
  return to_screen_ * camera_.to_screen(world) + shift_;
}

void ShapePen::point(Vec2 world) const {
  const Vec2 p = on_screen(world);
  if (!(std::abs(p.x) < 1e5 && std::abs(p.y) < 1e5)) return;
  const ImVec2 at = to_im(p);
  const float r = 5.0F * unit_;
  switch (look_.mark) {
    case PenMark::dot: list_.AddCircleFilled(at, r, look_.color); break;
    case PenMark::ring: list_.AddCircle(at, r + unit_, look_.color, 0, look_.width); break;
    case PenMark::square:
      list_.AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, look_.color, 0.0F, 0, look_.width);
      break;
  }
}

void ShapePen::circle(Vec2 center, double radius) const {
  const double r = radius / camera_.units_per_pixel() * to_screen_;
  const int corners = static_cast<int>(std::clamp(r, 48.0, 720.0));
  if (r < kLargestPenCirclePx)
    list_.AddCircle(to_im(on_screen(center)), static_cast<float>(r), look_.color, corners, look_.width);
}

void ShapePen::arc(const Arc& arc) const {
  const double r = arc.radius / camera_.units_per_pixel() * to_screen_;
  if (!(r < kLargestPenCirclePx)) return line(arc.from, arc.to);
  // Angles on the screen run the other way.
  const Vec2 start = arc.from - arc.center;
  const auto from = static_cast<float>(-std::atan2(start.y, start.x));
  list_.PathArcTo(to_im(on_screen(arc.center)), static_cast<float>(r), from - static_cast<float>(sweep_of(arc)), from,
                  static_cast<int>(std::clamp(r, 24.0, 360.0)));
  list_.PathStroke(look_.color, 0, look_.width);
}

void ShapePen::parabola(const ParabolaArc& arc) const {
  const std::vector<Vec2> corners = corners_of(arc);
  for (std::size_t i = 1; i < corners.size(); ++i) line(corners[i - 1], corners[i]);
}

void ShapePen::line(Vec2 a, Vec2 b) const {
  const Vec2 from = on_screen(a);
  stroke(list_, clipped(from, on_screen(b) - from, 0.0, 1.0, size_), look_);
}

void ShapePen::unbounded(Vec2 a, Vec2 d, double low) const {
  stroke(list_, clipped(on_screen(a), {d.x, -d.y}, low, std::numeric_limits<double>::infinity(), size_), look_);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/shapes_below.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/geometry/infinity.h"
#include "core/draw/primitive_values.h"

namespace mes {
namespace {

bool meet(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

bool meets_disk(const Box2& box, Vec2 center, double radius) {
  const Vec2 nearest{std::clamp(center.x, box.low.x, box.high.x), std::clamp(center.y, box.low.y, box.high.y)};
  return distance(nearest, center) <= radius;
}

bool meets_circle(const Box2& box, Vec2 center, double radius) {
  const double farthest = std::hypot(std::max(center.x - box.low.x, box.high.x - center.x),
                                     std::max(center.y - box.low.y, box.high.y - center.y));
  return farthest >= radius && meets_disk(box, center, radius);
}

/// True if a point at + t * way with t from `low` to `high` is in the box (Liang and Barsky, 1984).
bool meets_line(const Box2& box, Vec2 at, Vec2 way, double low, double high) {
  const auto cut = [&](double against, double room) {
    if (against == 0.0) return room >= 0.0;
    const double t = room / against;
    if (against < 0.0)
      low = std::max(low, t);
    else
      high = std::min(high, t);
    return low <= high;
  };
  return cut(-way.x, at.x - box.low.x) && cut(way.x, box.high.x - at.x) && cut(-way.y, at.y - box.low.y) &&
         cut(way.y, box.high.y - at.y);
}

bool meets_parabola(const Box2& box, const ParabolaArc& arc) {
  if (!meet(box, bounding_box_of(arc))) return false;
  const std::vector<Vec2> corners = corners_of(arc);
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (meets_line(box, corners[i - 1], corners[i] - corners[i - 1], 0.0, 1.0)) return true;
  return false;
}

/// The two are disjoint if and only if a side of one of them separates them.
bool meets_triangle(const Box2& box, const std::array<Vec2, 3>& corner) {
  Box2 bounds;
  for (const Vec2 p : corner) bounds.add(p);
  if (!meet(bounds, box)) return false;
  const std::array<Vec2, 4> ends{box.low, Vec2{box.high.x, box.low.y}, box.high, Vec2{box.low.x, box.high.y}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 from = corner[i];
    const Vec2 side = corner[(i + 1) % 3] - from;
    const double own = cross(side, corner[(i + 2) % 3] - from);
    if (std::ranges::all_of(ends, [&](Vec2 p) {
          return own > 0.0 ? cross(side, p - from) < 0.0 : own < 0.0 && cross(side, p - from) > 0.0;
        }))
      return false;
  }
  return true;
}

bool meets(const Box2& box, PrimitiveKind kind, const double* v) {
  switch (kind) {
    case PrimitiveKind::point: return box.contains({v[0], v[1]});
    case PrimitiveKind::disk: return meets_disk(box, {v[0], v[1]}, v[2]);
    case PrimitiveKind::circle: return meets_circle(box, {v[0], v[1]}, v[2]);
    case PrimitiveKind::segment: return meets_line(box, {v[0], v[1]}, Vec2{v[2], v[3]} - Vec2{v[0], v[1]}, 0.0, 1.0);
    case PrimitiveKind::ray: return meets_line(box, {v[0], v[1]}, {v[2], v[3]}, 0.0, kInfinity);
    case PrimitiveKind::line: return meets_line(box, {v[0], v[1]}, {v[2], v[3]}, -kInfinity, kInfinity);
    case PrimitiveKind::triangle: return meets_triangle(box, {Vec2{v[0], v[1]}, Vec2{v[2], v[3]}, Vec2{v[4], v[5]}});
    case PrimitiveKind::parabola: return meets_parabola(box, parabola_of(v));
    case PrimitiveKind::arc: break;
  }
  return meets_circle(box, {v[0], v[1]}, v[2]) && meet(bounding_box_of(arc_of(v)), box);
}

}  // namespace

std::size_t shapes_below(const LayerMirror& mirror, std::span<const VariantLayer> layers, const Box2& box) {
  std::size_t out = 0;
  for (const VariantLayer layer : layers) {
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      const std::span<const double> instances = mirror.instances(layer, kind);
      for (std::size_t at = 0; at < instances.size(); at += stride_of(kind))
        out += meets(box, kind, &instances[at]) ? 1U : 0U;
    }
  }
  return out;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/instance_encoder.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/geometry/arc.h"
#include "core/base/geometry/vec2.h"
#include "render/device/instance_layout.h"

namespace mes::render {
namespace {

// The position of invisible instances: a corner of the range, about 10^18 drawing sizes away.
constexpr double kNowhere = kDrawingLimit;

// Only for huge coordinates: mapping them would overflow the exponents of a double.
using Wide = long double;
struct WideVec2 {
  Wide x;
  Wide y;
};

Vec2 map(const DrawingFrame& frame, double x, double y) {
  return {(x - frame.origin.x) * frame.scale, (y - frame.origin.y) * frame.scale};
}
WideVec2 map_wide(const DrawingFrame& frame, double x, double y) {
  return {(Wide{x} - Wide{frame.origin.x}) * Wide{frame.scale}, (Wide{y} - Wide{frame.origin.y}) * Wide{frame.scale}};
}
bool in_range(Vec2 p) {
  // NaN fails this test, too.
  return std::abs(p.x) <= kDrawingLimit && std::abs(p.y) <= kDrawingLimit;
}
double size_of(Vec2 p) {
  return std::max(std::abs(p.x), std::abs(p.y));
}

/// Reduces [t0, t1] to the t with p + t d inside the range; false if there is no such t.
bool cut(WideVec2 p, WideVec2 d, Wide& t0, Wide& t1) {
  const Wide limit = kDrawingLimit;
  const auto slab = [&](Wide start, Wide slope) {
    if (slope == 0) return std::abs(start) <= limit;
    const Wide a = (-limit - start) / slope;
    const Wide b = (limit - start) / slope;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
    return true;
  };
  return slab(p.x, d.x) && slab(p.y, d.y) && t0 <= t1;
}

Vec2 along(WideVec2 p, WideVec2 d, Wide t) {
  const auto number = [](Wide v) { return std::clamp(static_cast<double>(v), -kDrawingLimit, kDrawingLimit); };
  return {number(p.x + t * d.x), number(p.y + t * d.y)};
}

void store(std::span<double> out, std::size_t column, Vec2 p) {
  out[2 * column] = p.x;
  out[2 * column + 1] = p.y;
}

void encode_segment(const DrawingFrame& frame, std::span<const double> in, std::span<double> out) {
  Vec2 a = map(frame, in[0], in[1]);
  Vec2 b = map(frame, in[2], in[3]);
  if (!in_range(a) || !in_range(b)) {
    const WideVec2 p = map_wide(frame, in[0], in[1]);
    const WideVec2 q = map_wide(frame, in[2], in[3]);
    // Starts from the nearer end, because rounding errors are relative to the numbers added.
    const bool from_p = std::max(std::abs(p.x), std::abs(p.y)) <= std::max(std::abs(q.x), std::abs(q.y));
    const WideVec2 start = from_p ? p : q;
    const WideVec2 step = from_p ? WideVec2{q.x - p.x, q.y - p.y} : WideVec2{p.x - q.x, p.y - q.y};
    Wide t0 = 0;
    Wide t1 = 1;
    if (std::isfinite(step.x) && std::isfinite(step.y) && cut(start, step, t0, t1)) {
      a = along(start, step, t0);
      b = along(start, step, t1);
      if (!from_p) std::swap(a, b);
    } else {
      a = b = {kNowhere, kNowhere};
    }
  }
  store(out, 0, a);
  store(out, 1, b);
}

/// Encodes rays and lines: a point and a unit direction.
void encode_unbounded(PrimitiveKind kind, const DrawingFrame& frame, std::span<const double> in,
                      std::span<double> out) {
  Vec2 p = map(frame, in[0], in[1]);
  const double size = std::max(std::abs(in[2]), std::abs(in[3]));
  Vec2 d{in[2] / size, in[3] / size};
  const double norm = length(d);
  d = {d.x / norm, d.y / norm};
  if (!is_finite(d) || size == 0.0) {
    p = {kNowhere, kNowhere};
    d = {kind == PrimitiveKind::ray ? 1.0 : 0.0, kind == PrimitiveKind::ray ? 0.0 : 1.0};
  } else if (!in_range(p)) {
    const WideVec2 start = map_wide(frame, in[0], in[1]);
    const WideVec2 step{d.x, d.y};
    Wide t0 = kind == PrimitiveKind::ray ? Wide{0} : -std::numeric_limits<Wide>::max();
    Wide t1 = std::numeric_limits<Wide>::max();
    if (std::isfinite(start.x) && std::isfinite(start.y) && cut(start, step, t0, t1)) {
      p = along(start, step, t0);
    } else {
      p = {kNowhere, kNowhere};
      d = kind == PrimitiveKind::ray ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
    }
  }
  store(out, 0, p);
  store(out, 1, d);
}

void encode_arc(const DrawingFrame& frame, std::span<const double> in, std::span<double> out,
                InstanceExtent& extent) {
  const Arc arc{.center = map(frame, in[0], in[1]),
                .radius = in[2] * frame.scale,
                .from = map(frame, in[3], in[4]),
                .to = map(frame, in[5], in[6])};
  const bool shown = in_range(arc.center) && in_range(arc.from) && in_range(arc.to) && arc.radius >= 0.0 &&
                     arc.radius <= kDrawingLimit;
  const std::array columns{arc.center, arc.from, arc.to};
  for (std::size_t i = 0; i < columns.size(); ++i) store(out, i, shown ? columns[i] : Vec2{kNowhere, kNowhere});
  out[6] = shown ? arc.radius : -1.0;
  // Single precision cannot decide which of two very close ends is the first, so out[7] records it. If only the frame
  // makes the ends equal, those of the document decide the direction of the arc.
  const bool is_whole = in[3] == in[5] && in[4] == in[6];
  const Arc given{{in[0], in[1]}, in[2], {in[3], in[4]}, {in[5], in[6]}};
  const double sweep = sweep_of(!is_whole && arc.from == arc.to ? given : arc);
  const bool is_drawn_whole = is_whole || (arc.from == arc.to && sweep > std::numbers::pi);
  out[7] = is_drawn_whole ? 2.0 : (sweep > std::numbers::pi ? 1.0 : 0.0);
  if (!shown) return;
  extent.radius = std::max(extent.radius, arc.radius);
  extent.length = std::max(extent.length, arc.radius * sweep);
}

}  // namespace

void encode_instance(PrimitiveKind kind, const DrawingFrame& frame, std::span<const double> in, std::span<double> out,
                     InstanceExtent& extent) {
  switch (kind) {
    case PrimitiveKind::point: {
      const Vec2 p = map(frame, in[0], in[1]);
      store(out, 0, in_range(p) ? p : Vec2{kNowhere, kNowhere});
      break;
    }
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: {
      const Vec2 p = map(frame, in[0], in[1]);
      const double r = in[2] * frame.scale;
      const bool shown = in_range(p) && r >= 0.0 && r <= kDrawingLimit;
      store(out, 0, shown ? p : Vec2{kNowhere, kNowhere});
      // Programs draw nothing for a negative radius.
      out[2] = shown ? r : -1.0;
      if (shown) extent.radius = std::max(extent.radius, r);
      break;
    }
    case PrimitiveKind::segment: encode_segment(frame, in, out); break;
    case PrimitiveKind::ray:
    case PrimitiveKind::line: encode_unbounded(kind, frame, in, out); break;
    case PrimitiveKind::parabola:
    case PrimitiveKind::triangle: {
      bool shown = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 p = map(frame, in[2 * i], in[2 * i + 1]);
        shown = shown && in_range(p);
        store(out, i, p);
      }
      if (!shown) std::fill(out.begin(), out.end(), kNowhere);
      if (shown && kind == PrimitiveKind::parabola)
        extent.length = std::max(extent.length, length((Vec2{out[4], out[5]} - Vec2{out[2], out[3]}) -
                                                       (Vec2{out[2], out[3]} - Vec2{out[0], out[1]})));
      break;
    }
    case PrimitiveKind::arc: encode_arc(frame, in, out, extent); break;
  }
  const std::size_t points = kind == PrimitiveKind::ray || kind == PrimitiveKind::line
                                 ? std::size_t{1}
                                 : std::size_t{layout_of(kind).points};
  for (std::size_t i = 0; i < points; ++i) {
    const double size = size_of({out[2 * i], out[2 * i + 1]});
    if (size < kNowhere) extent.coordinate = std::max(extent.coordinate, size);
  }
}

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/annotations/highlight_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/geometry/arc.h"
#include "core/base/geometry/parabola_arc.h"

namespace mes {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kPoint = 5.0;  // half the size of a point mark

/// The unit vector of this direction; zero if its length is zero or not finite.
Vec2 along(Vec2 way) {
  const double size = length(way);
  return size > 0.0 && std::isfinite(size) ? (1.0 / size) * way : Vec2{};
}

/// The positions of anchors, one after the other.
class HighlightPlaces {
 public:
  HighlightPlaces(const Annotation& annotation, const Document& document)
      : next_(annotation.anchors.begin()), document_(document) {}
  const Anchor& anchor() { return *next_++; }
  Vec2 place() { return document_.place_of(anchor()); }
  double radius_unit(const Anchor& anchor) const { return document_.radius_unit(anchor); }
  Vec2 place_of(const Anchor& anchor) const { return document_.place_of(anchor); }

 private:
  std::vector<Anchor>::const_iterator next_;
  const Document& document_;
};

ProvenanceShape shape_of(const HighlightedElement& element, HighlightPlaces& places) {
  ProvenanceShape out{.kind = element.kind};
  auto& v = out.values;
  switch (element.kind) {
    case PrimitiveKind::point: {
      const Vec2 p = places.place();
      v = {p.x, p.y};
      break;
    }
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: {
      const Anchor& anchor = places.anchor();
      const Vec2 center = places.place_of(anchor);
      v = {center.x, center.y, element.radius * places.radius_unit(anchor)};
      break;
    }
    case PrimitiveKind::segment: {
      const Vec2 a = places.place();
      const Vec2 b = places.place();
      v = {a.x, a.y, b.x, b.y};
      break;
    }
    case PrimitiveKind::parabola:
    case PrimitiveKind::triangle: {
      const Vec2 a = places.place();
      const Vec2 b = places.place();
      const Vec2 c = places.place();
      v = {a.x, a.y, b.x, b.y, c.x, c.y};
      break;
    }
    case PrimitiveKind::arc: {
      const Vec2 center = places.place();
      const Vec2 from = places.place();
      const Vec2 to = places.place();
      v = {center.x, center.y, distance(center, from), from.x, from.y, to.x, to.y};
      break;
    }
    case PrimitiveKind::line: {
      const Vec2 a = places.place();
      const Vec2 b = places.place();
      const Vec2 through = 0.5 * a + 0.5 * b;
      const Vec2 way = perpendicular(b - a);
      v = {through.x, through.y, way.x, way.y};
      break;
    }
    case PrimitiveKind::ray: {
      const Vec2 from = places.place();
      const Vec2 a = places.place();
      const Vec2 way = perpendicular(places.place() - a);
      v = {from.x, from.y, way.x, way.y};
      break;
    }
  }
  return out;
}

double distance_to_part(Vec2 p, Vec2 at, Vec2 way, double low, double high) {
  const double squared = dot(way, way);
  const double t = squared > 0.0 ? std::clamp(dot(p - at, way) / squared, low, high) : 0.0;
  return length(p - (at + t * way));
}

}  // namespace

Rgb highlight_color(ProvenanceRole role) {
  switch (role) {
    case ProvenanceRole::itself: return palette::vermilion;
    case ProvenanceRole::origin: return palette::orange;
    case ProvenanceRole::product: return palette::purple;
  }
  return palette::black;
}

std::vector<HighlightedShape> highlighted_shapes(const Annotation& annotation, const Document& document) {
  std::vector<HighlightedShape> out;
  HighlightPlaces places(annotation, document);
  for (const HighlightedElement& element : annotation.elements) {
    const ProvenanceShape shape = shape_of(element, places);
    if (std::ranges::all_of(shape.values, [](double x) { return std::isfinite(x); }))
      out.push_back({shape, element.role});
  }
  return out;
}

void HighlightPen::point(Vec2 at, ProvenanceRole role, Rgb color) {
  if (!plane_.reaches(at)) return;
  switch (role) {
    case ProvenanceRole::itself: drawing_.dots.push_back({at.x, at.y, kPoint, color}); break;
    case ProvenanceRole::origin: plane_.circle(at, kPoint + 1.0, kHighlightLine, color); break;
    case ProvenanceRole::product: {
      const Vec2 a = at + Vec2{-kPoint, -kPoint};
      const Vec2 b = at + Vec2{kPoint, -kPoint};
      const Vec2 c = at + Vec2{kPoint, kPoint};
      const Vec2 d = at + Vec2{-kPoint, kPoint};
      // Repeats the first side, so that the corner at the end is a joint.
      drawing_.strokes.push_back({{a, b, c, d, a, b}, kHighlightLine, color});
      break;
    }
  }
}

void HighlightPen::draw(const HighlightedShape& highlighted) {
  const auto& v = highlighted.shape.values;
  const Rgb color = highlight_color(highlighted.role);
  const Vec2 a = plane_.on_paper({v[0], v[1]});
  const auto second = [&] { return plane_.on_paper(Vec2{v[2], v[3]}); };
  const auto third = [&] { return plane_.on_paper(Vec2{v[4], v[5]}); };
  const auto segment = [&](Vec2 from, Vec2 to) { plane_.segment(from, to, kHighlightLine, color); };
  // The y axis of the drawing points down.
  const auto endless = [&](double low) {
    plane_.line(a, along({v[2], -v[3]}), low, kEndless, kHighlightLine, color);
  };
  switch (highlighted.shape.kind) {
    case PrimitiveKind::point: return point(a, highlighted.role, color);
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: return plane_.circle(a, plane_.on_paper(v[2]), kHighlightLine, color);
    case PrimitiveKind::segment: return segment(a, second());
    case PrimitiveKind::triangle:
      segment(a, second());
      segment(second(), third());
      return segment(third(), a);
    case PrimitiveKind::parabola: {
      const std::vector<Vec2> corners = corners_of(ParabolaArc{a, second(), third()});
      for (std::size_t i = 1; i < corners.size(); ++i) segment(corners[i - 1], corners[i]);
      return;
    }
    case PrimitiveKind::ray: return endless(0.0);
    case PrimitiveKind::line: return endless(-kEndless);
    case PrimitiveKind::arc: {
      // Counter-clockwise in the plane means from the end to the beginning, which is clockwise on the drawing.
      const Vec2 end = Vec2{v[5], v[6]} - Vec2{v[0], v[1]};
      return plane_.arc(a, plane_.on_paper(v[2]), std::atan2(-end.y, end.x),
                        sweep_of({{v[0], v[1]}, v[2], {v[3], v[4]}, {v[5], v[6]}}), kHighlightLine, color);
    }
  }
}

double highlight_distance(const ProvenanceShape& shape, Vec2 px, const SeenPlane& plane) {
  PaperDrawing none;
  const PlaneDrawing on(none, plane);
  const auto& v = shape.values;
  const Vec2 a = on.on_paper(Vec2{v[0], v[1]});
  const auto second = [&] { return on.on_paper(Vec2{v[2], v[3]}); };
  const auto third = [&] { return on.on_paper(Vec2{v[4], v[5]}); };
  const auto to_segment = [px](Vec2 from, Vec2 to) { return distance_to_part(px, from, to - from, 0.0, 1.0); };
  switch (shape.kind) {
    case PrimitiveKind::point: return distance(px, a);
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: return std::abs(distance(px, a) - on.on_paper(v[2]));
    case PrimitiveKind::segment: return to_segment(a, second());
    case PrimitiveKind::triangle:
      return std::min({to_segment(a, second()), to_segment(second(), third()), to_segment(third(), a)});
    case PrimitiveKind::parabola: return distance_to(ParabolaArc{a, second(), third()}, px);
    case PrimitiveKind::ray: return distance_to_part(px, a, along({v[2], -v[3]}), 0.0, kEndless);
    case PrimitiveKind::line: return distance_to_part(px, a, along({v[2], -v[3]}), -kEndless, kEndless);
    case PrimitiveKind::arc: {
      const Vec2 ends[2] = {on.on_paper(Vec2{v[3], v[4]}), on.on_paper(Vec2{v[5], v[6]})};
      // The drawing is mirrored, so the ends are swapped.
      const Arc arc{a, on.on_paper(v[2]), ends[1], ends[0]};
      const bool is_beside = arc.from == arc.to || sweep_of({a, arc.radius, arc.from, px}) <= sweep_of(arc);
      return is_beside ? std::abs(distance(px, a) - arc.radius)
                       : std::min(distance(px, ends[0]), distance(px, ends[1]));
    }
  }
  return kEndless;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mes {
namespace {

/// Interpolates linearly; a coordinate that is the same at both ends stays exactly the same.
Vec2 between(Vec2 a, Vec2 b, double t) {
  return a + t * (b - a);
}

Vec2 on_ellipse(const EllipticArc& arc, double angle) {
  return arc.center + (std::cos(angle) * arc.u + std::sin(angle) * arc.v);
}

/// The derivative by the angle.
Vec2 along_ellipse(const EllipticArc& arc, double angle) {
  return std::cos(angle) * arc.v - std::sin(angle) * arc.u;
}

std::size_t point_count(PieceKind kind) {
  switch (kind) {
    case PieceKind::line:
    case PieceKind::arc: return 2;
    case PieceKind::quadratic: return 3;
    case PieceKind::cubic: return 4;
  }
  return 2;
}

/// The parabola with this control point has the ends of the arc and its tangents there. Neither the centre nor the angle
/// counts, which rounding moves by more than the height of the arc.
Vec2 control_of_parabola(const EllipticArc& arc, Vec2 from, Vec2 to) {
  const double area = cross(arc.u, arc.v);
  const Vec2 half = 0.5 * to - 0.5 * from;
  const Vec2 chord{cross(half, arc.v) / area, cross(arc.u, half) / area};  // where the ellipse is the unit circle
  Vec2 way = length(chord) / std::sqrt(1.0 - dot(chord, chord)) * perpendicular(chord);
  const double middle = arc.start + 0.5 * arc.sweep;
  if (dot(way, {std::cos(middle), std::sin(middle)}) < 0.0) way = -way;
  return 0.5 * from + 0.5 * to + way.x * arc.u + way.y * arc.v;
}

}  // namespace

// Source: SVG 2, appendix B.2.4 and B.2.5: scaling by the axes turns the ellipse into a unit circle.
std::optional<EllipticArc> arc_between(Vec2 from, Vec2 to, Vec2 radii, double rotation, bool is_large,
                                       bool turns_to_v) {
  radii = {std::abs(radii.x), std::abs(radii.y)};
  if (radii.x == 0.0 || radii.y == 0.0 || from == to) return std::nullopt;
  const double cosine = std::cos(rotation);
  const double sine = std::sin(rotation);
  const Vec2 half{0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y};
  const Vec2 middle{0.5 * to.x + 0.5 * from.x, 0.5 * to.y + 0.5 * from.y};
  const Vec2 chord{(cosine * half.x + sine * half.y) / radii.x, (cosine * half.y - sine * half.x) / radii.y};
  const double reach = length(chord);
  if (!std::isfinite(reach) || reach == 0.0) return std::nullopt;

  // In units of the axes, relative to the middle of the chord.
  const double height = reach < 1.0 ? std::sqrt((1.0 - reach) * (1.0 + reach)) : 0.0;
  const Vec2 center = (is_large == turns_to_v ? -height / reach : height / reach) * perpendicular(chord);
  if (reach >= 1.0) radii = reach * radii;
  const Vec2 begin = -1.0 / std::max(reach, 1.0) * chord - center;

  EllipticArc arc;
  arc.u = radii.x * Vec2{cosine, sine};
  arc.v = radii.y * Vec2{-sine, cosine};
  arc.center = middle + (center.x * arc.u + center.y * arc.v);
  arc.start = std::atan2(begin.y, begin.x);
  arc.sweep = 2.0 * std::atan2(std::min(reach, 1.0), is_large ? -height : height);
  if (!turns_to_v) arc.sweep = -arc.sweep;
  return arc;
}

Vec2 Piece::to() const {
  return points[point_count(kind) - 1];
}

Vec2 Piece::at(double t) const {
  if (t <= 0.0) return from();
  if (t >= 1.0) return to();
  if (kind == PieceKind::arc) return on_ellipse(arc, arc.start + t * arc.sweep);
  // De Casteljau's algorithm, which is stable near the ends.
  std::array<Vec2, 4> p = points;
  for (std::size_t left = point_count(kind) - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) p[i] = between(p[i], p[i + 1], t);
  return p[0];
}

Vec2 Piece::derivative(double t) const {
  const auto& p = points;
  switch (kind) {
    case PieceKind::line: return p[1] - p[0];
    case PieceKind::quadratic: return 2.0 * between(p[1] - p[0], p[2] - p[1], t);
    case PieceKind::cubic:
      return 3.0 * between(between(p[1] - p[0], p[2] - p[1], t), between(p[2] - p[1], p[3] - p[2], t), t);
    case PieceKind::arc: return arc.sweep * along_ellipse(arc, arc.start + t * arc.sweep);
  }
  return {};
}

Vec2 Piece::first_direction() const {
  if (kind == PieceKind::arc) return derivative(0.0);
  for (std::size_t i = 1; i < point_count(kind); ++i)
    if (points[i] != points[0]) return points[i] - points[0];
  return {};
}

Vec2 Piece::last_direction() const {
  if (kind == PieceKind::arc) return derivative(1.0);
  const Vec2 last = to();
  for (std::size_t i = point_count(kind) - 1; i-- > 0;)
    if (points[i] != last) return last - points[i];
  return {};
}

Piece Piece::part(double begin, double end) const {
  Piece out{.kind = kind};
  out.points[0] = at(begin);
  if (kind == PieceKind::line || kind == PieceKind::arc) {
    out.points[1] = at(end);
    out.arc = arc;
    out.arc.start = arc.start + begin * arc.sweep;
    out.arc.sweep = (end - begin) * arc.sweep;
    return out;
  }
  // The control points of the part are values of the polar form (blossom) at all combinations of begin and end.
  const std::size_t degree = point_count(kind) - 1;
  for (std::size_t k = 1; k < degree; ++k) {
    std::array<Vec2, 4> p = points;
    std::size_t left = degree;
    for (std::size_t step = 0; step < degree; ++step, --left) {
      const double t = step < k ? end : begin;
      for (std::size_t i = 0; i < left; ++i) p[i] = between(p[i], p[i + 1], t);
    }
    out.points[k] = p[0];
  }
  out.points[degree] = at(end);
  return out;
}

std::optional<PlaneCurve> PlaneCurve::of_parts(std::vector<Vec2> points, std::vector<PieceKind> kinds,
                                               std::vector<EllipticArc> arcs, bool is_closed) {
  std::size_t point_number = 1;
  std::size_t arc_number = 0;
  bool is_polyline = true;
  for (const PieceKind kind : kinds) {
    point_number += points_added(kind);
    arc_number += kind == PieceKind::arc ? 1U : 0U;
    is_polyline = is_polyline && kind == PieceKind::line;
  }
  if (points.size() != point_number || arcs.size() != arc_number) return std::nullopt;
  if (is_closed && points.front() != points.back()) return std::nullopt;
  PlaneCurve out(points.front());
  out.points_ = std::move(points);
  out.kinds_ = std::move(kinds);
  out.arcs_ = std::move(arcs);
  out.is_closed_ = is_closed;
  out.is_polyline_ = is_polyline;
  return out;
}

void PlaneCurve::add(const Piece& piece) {
  switch (piece.kind) {
    case PieceKind::line: return line_to(piece.points[1]);
    case PieceKind::quadratic: return quadratic_to(piece.points[1], piece.points[2]);
    case PieceKind::cubic: return cubic_to(piece.points[1], piece.points[2], piece.points[3]);
    case PieceKind::arc: return arc_to(piece.arc, piece.points[1]);
  }
}

void PlaneCurve::line_to(Vec2 to) {
  points_.push_back(to);
  kinds_.push_back(PieceKind::line);
}

void PlaneCurve::lines_to(std::span<const Vec2> to) {
  // Reserve room for the closing line too.
  const std::size_t wanted = points_.size() + to.size() + 1;
  if (wanted > points_.capacity()) points_.reserve(std::max(wanted, 2 * points_.size()));
  if (wanted > kinds_.capacity()) kinds_.reserve(std::max(wanted, 2 * kinds_.size()));
  points_.insert(points_.end(), to.begin(), to.end());
  kinds_.insert(kinds_.end(), to.size(), PieceKind::line);
}

void PlaneCurve::quadratic_to(Vec2 control, Vec2 to) {
  points_.insert(points_.end(), {control, to});
  kinds_.push_back(PieceKind::quadratic);
  is_polyline_ = false;
}

void PlaneCurve::cubic_to(Vec2 first, Vec2 second, Vec2 to) {
  points_.insert(points_.end(), {first, second, to});
  kinds_.push_back(PieceKind::cubic);
  is_polyline_ = false;
}

void PlaneCurve::arc_to(const EllipticArc& arc, Vec2 to) {
  constexpr double kFlat = 0x1p-16;
  if (std::abs(arc.sweep) <= kFlat) {
    const Vec2 middle = 0.5 * end() + 0.5 * to;
    const Vec2 control = control_of_parabola(arc, end(), to);
    if (control == middle) return line_to(to);
    if (is_finite(control)) return quadratic_to(control, to);
  }
  points_.push_back(to);
  kinds_.push_back(PieceKind::arc);
  arcs_.push_back(arc);
  is_polyline_ = false;
}

void PlaneCurve::close() {
  if (end() != start()) line_to(start());
  is_closed_ = true;
}

void PlaneCurve::transform(const Affine& map) {
  for (Vec2& point : points_) point = map.of_point(point);
  for (EllipticArc& arc : arcs_) {
    arc.center = map.of_point(arc.center);
    arc.u = map.of_vector(arc.u);
    arc.v = map.of_vector(arc.v);
  }
}

}  // namespace mes

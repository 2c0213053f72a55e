// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/nearest_place.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mes {
namespace {

/// Whether the piece can come within `reach` of the point: it lies among its control points, and an arc in the box of its
/// whole ellipse.
bool may_be_near(const Piece& piece, Vec2 p, double reach) {
  Vec2 low;
  Vec2 high;
  if (piece.kind == PieceKind::arc) {
    const EllipticArc& arc = piece.arc;
    const Vec2 half{std::hypot(arc.u.x, arc.v.x), std::hypot(arc.u.y, arc.v.y)};
    low = arc.center - half;
    high = arc.center + half;
  } else {
    const std::size_t count = piece.kind == PieceKind::line ? 2 : piece.kind == PieceKind::quadratic ? 3 : 4;
    low = high = piece.points[0];
    for (std::size_t i = 1; i < count; ++i) {
      low = {std::min(low.x, piece.points[i].x), std::min(low.y, piece.points[i].y)};
      high = {std::max(high.x, piece.points[i].x), std::max(high.y, piece.points[i].y)};
    }
  }
  return p.x >= low.x - reach && p.x <= high.x + reach && p.y >= low.y - reach && p.y <= high.y + reach;
}

Vec2 nearest_on_line(const Piece& line, Vec2 p) {
  const Vec2 along = line.points[1] - line.points[0];
  const double size = dot(along, along);
  return line.at(size > 0.0 ? std::clamp(dot(p - line.points[0], along) / size, 0.0, 1.0) : 0.0);
}

Vec2 nearest_on(const Piece& piece, Vec2 p) {
  if (piece.kind == PieceKind::line) return nearest_on_line(piece, p);
  constexpr int kIntervals = 32;
  int best = 0;
  for (int i = 1; i <= kIntervals; ++i)
    if (distance(piece.at(static_cast<double>(i) / kIntervals), p) <
        distance(piece.at(static_cast<double>(best) / kIntervals), p))
      best = i;
  // The least distance lies in the two intervals beside it; of a piece that comes back to where it begins, these are its
  // first and its last. Sections in the golden ratio narrow them down.
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kSmall = 1e-9;
  const auto narrowed = [&](double low, double high) {
    while (high - low > kSmall) {
      const double a = high - kGolden * (high - low);
      const double b = low + kGolden * (high - low);
      if (distance(piece.at(a), p) < distance(piece.at(b), p))
        high = b;
      else
        low = a;
    }
    return piece.at(0.5 * (low + high));
  };
  constexpr double kInterval = 1.0 / kIntervals;
  std::array<Vec2, 4> found{
      piece.at(0.0), piece.at(1.0),
      narrowed(std::max(0.0, (best - 1.0) * kInterval), std::min(1.0, (best + 1.0) * kInterval)), piece.at(1.0)};
  if (best == 0 && piece.from() == piece.to()) found[3] = narrowed(1.0 - kInterval, 1.0);
  return *std::ranges::min_element(found, {}, [&](Vec2 place) { return distance(place, p); });
}

}  // namespace

std::optional<Vec2> nearest_place(const CurveSet& curves, Vec2 p, double reach) {
  std::optional<Vec2> best;
  for (const PlaneCurve& curve : curves.curves)
    curve.for_each_piece([&](const Piece& piece) {
      if (!may_be_near(piece, p, reach)) return;
      const Vec2 place = nearest_on(piece, p);
      const double away = distance(place, p);
      if (away > reach || (best && away == reach)) return;
      reach = away;
      best = place;
    });
  return best;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/nearest_place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curves/curve_bounds.h"

namespace mes {
namespace {

double nearest_on_line(const Piece& line, Vec2 p) {
  const Vec2 along = line.points[1] - line.points[0];
  const double size = dot(along, along);
  return size > 0.0 ? std::clamp(dot(p - line.points[0], along) / size, 0.0, 1.0) : 0.0;
}

}  // namespace

double nearest_parameter(const Piece& piece, Vec2 p) {
  if (piece.kind == PieceKind::line) return nearest_on_line(piece, p);
  constexpr int kIntervals = 32;
  int best = 0;
  for (int i = 1; i <= kIntervals; ++i)
    if (distance(piece.at(static_cast<double>(i) / kIntervals), p) <
        distance(piece.at(static_cast<double>(best) / kIntervals), p))
      best = i;
  // The minimum lies in the two intervals beside it; if a piece returns to its beginning, these are the first and the
  // last. Golden-section search narrows them down.
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
    return 0.5 * (low + high);
  };
  constexpr double kInterval = 1.0 / kIntervals;
  std::array<double, 4> found{
      0.0, 1.0, narrowed(std::max(0.0, (best - 1.0) * kInterval), std::min(1.0, (best + 1.0) * kInterval)), 1.0};
  if (best == 0 && piece.from() == piece.to()) found[3] = narrowed(1.0 - kInterval, 1.0);
  return *std::ranges::min_element(found, {}, [&](double t) { return distance(piece.at(t), p); });
}

std::optional<Vec2> nearest_place(const CurveSet& curves, Vec2 p, double reach) {
  std::optional<Vec2> best;
  for (const PlaneCurve& curve : curves.curves)
    curve.for_each_piece([&](const Piece& piece) {
      const Box2 box = bounds_of(piece);
      if (p.x < box.low.x - reach || p.x > box.high.x + reach || p.y < box.low.y - reach || p.y > box.high.y + reach)
        return;
      const Vec2 place = piece.at(nearest_parameter(piece, p));
      const double away = distance(place, p);
      if (away > reach || (best && away == reach)) return;
      reach = away;
      best = place;
    });
  return best;
}

}  // namespace mes

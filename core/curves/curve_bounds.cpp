// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/curve_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mes {
namespace {

/// Adds the points where the derivative a t^2 + b t + c of one coordinate is zero.
void add_level(const Piece& piece, double a, double b, double c, Box2& box) {
  const auto add = [&](double t) {
    if (t > 0.0 && t < 1.0) box.add(piece.at(t));
  };
  const double discriminant = b * b - 4.0 * a * c;
  if (!(discriminant >= 0.0)) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  if (a != 0.0) add(q / a);
  if (q != 0.0) add(c / q);
}

void add_turns(const Piece& piece, double u, double v, Box2& box) {
  // cos(w) u + sin(w) v has its extrema where w = atan2(v, u), up to half turns.
  constexpr double kPi = std::numbers::pi;
  if (piece.arc.sweep == 0.0) return;
  const double first = std::min(piece.arc.start, piece.arc.start + piece.arc.sweep);
  const double last = std::max(piece.arc.start, piece.arc.start + piece.arc.sweep);
  const double w = std::atan2(v, u);
  for (double turn = w + kPi * std::ceil((first - w) / kPi); turn < last; turn += kPi)
    box.add(piece.at((turn - piece.arc.start) / piece.arc.sweep));
}

}  // namespace

Box2 bounds_of(const Piece& piece) {
  Box2 box;
  box.add(piece.from());
  box.add(piece.to());
  const auto& p = piece.points;
  for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
    if (piece.kind == PieceKind::arc) {
      add_turns(piece, piece.arc.u.*axis, piece.arc.v.*axis, box);
    } else if (piece.kind == PieceKind::quadratic) {
      add_level(piece, 0.0, p[0].*axis - 2.0 * p[1].*axis + p[2].*axis, p[1].*axis - p[0].*axis, box);
    } else if (piece.kind == PieceKind::cubic) {
      const double first = p[1].*axis - p[0].*axis;
      const double second = p[2].*axis - p[1].*axis;
      const double third = p[3].*axis - p[2].*axis;
      add_level(piece, first - 2.0 * second + third, 2.0 * (second - first), first, box);
    }
  }
  return box;
}

Box2 bounds_of(std::span<const PlaneCurve> curves) {
  Box2 box;
  for (const PlaneCurve& curve : curves) {
    box.add(curve.start());
    curve.for_each_piece([&](const Piece& piece) { box.add(bounds_of(piece)); });
  }
  return box;
}

}  // namespace mes

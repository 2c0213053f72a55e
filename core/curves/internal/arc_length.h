// SPDX-License-Identifier: GPL-3.0-or-later
// The length of a piece of a curve, and the parameter at a given length. Private to core/curves.
//
// Gauss-Legendre quadrature with eight points, on intervals that are halved until the sum of both halves agrees with
// the whole within 1e-12 of the length of the control polygon. A piece is first cut where its speed is least: near the
// end of a piece, the curve may turn back beyond the last quadrature point. Lines need no quadrature.
#pragma once

#include <array>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

class PieceLength {
 public:
  explicit PieceLength(const Piece& piece);

  double total() const { return total_; }
  /// The parameter at arc length `wanted` from the beginning; 0 and 1 beyond the ends. Cost: logarithmic in the number
  /// of intervals.
  double parameter_at(double wanted) const;

 private:
  struct Interval {
    double end;     // parameter
    double length;  // length from the beginning of the piece to `end`
  };
  Vec2 velocity_at(double t) const;
  double quadrature(double begin, double end) const;
  std::vector<double> slowest_places_of_arc() const;
  void halve(double begin, double end, double whole, double tolerance, int depth);

  Piece piece_;
  std::array<Vec2, 3> velocity_{};   // coefficients of the derivative, constant term first; not used for arcs
  std::vector<Interval> intervals_;  // empty for lines
  double total_ = 0.0;
};

}  // namespace mes

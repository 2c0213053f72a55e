// SPDX-License-Identifier: GPL-3.0-or-later
// B-splines, rational or not, as curves of cubic pieces.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

struct BSpline {
  std::size_t degree = 3;
  std::vector<double> knots{};  ///< as many as control points, and the degree, and one
  std::vector<Vec2> controls{};
  std::vector<double> weights{};  ///< of each control point; none: all equal

  /// Knots 0 and the last one `degree` + 1 times, and 1, 2, ... between: it begins and ends at control points.
  static BSpline clamped(std::size_t degree, std::vector<Vec2> controls);
  /// Uniform knots, and the first controls again at the end: closed, and as smooth as can be.
  static BSpline closed(std::size_t degree, const std::vector<Vec2>& controls);
};

/// Up to rounding the spline itself where its degree is at most 3 and its weights are equal; else cubic pieces that have
/// its places and tangents at 32 places of each span, off by less than 1e-6 of its size where weights are
/// of one magnitude. A spline jumps where `degree` + 1 knots are equal and the controls on both sides are not: it is several curves then, in order.
/// Knots that differ by less than 1e-10 of their range are equal; so are those that decrease by less than 1e-6 of it, as rounding may make them.
/// Nothing for an invalid spline: knots that are too few or decrease, a degree of 0 or above 15, weights that are not
/// positive, numbers that are not finite.
std::vector<PlaneCurve> curves_of_spline(BSpline spline);

/// The same of a spline that is one curve; nothing for one that jumps.
///
/// Smallest use:
///     const auto curve = curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 0}}));
std::optional<PlaneCurve> curve_of_spline(BSpline spline);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Converts B-splines, rational or not, to curves of cubic pieces.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

struct BSpline {
  std::size_t degree = 3;
  std::vector<double> knots{};  ///< their number is that of the control points plus `degree` plus one
  std::vector<Vec2> controls{};
  std::vector<double> weights{};  ///< one for each control point; empty if all are equal

  /// Clamped: knots 1, 2, ... between end knots of multiplicity `degree` + 1, so that it begins and ends at control
  /// points.
  static BSpline clamped(std::size_t degree, std::vector<Vec2> controls);
  /// Closed spline of maximal smoothness: uniform knots, and the first control points repeated at the end.
  static BSpline closed(std::size_t degree, const std::vector<Vec2>& controls);
};

/// Converts a spline to curves. If its degree is at most 3 and its weights are equal, the result is the spline itself
/// up to rounding. Otherwise it consists of cubic pieces with the positions and tangents of the spline at 32 points of
/// each span; the error is below 1e-6 of its size if the weights are of one magnitude. A spline jumps where `degree` +
/// 1 knots are equal and the control points on both sides differ; it then becomes several curves, in order. Knots that
/// differ by less than 1e-10 of their range count as equal; so do knots that decrease by less than 1e-6 of it, as
/// rounding may make them. Returns nothing for an invalid spline: too few or decreasing knots, a degree of 0 or above
/// 15, weights that are not positive, or numbers that are not finite.
std::vector<PlaneCurve> curves_of_spline(BSpline spline);

/// The same for a spline that is one curve; returns nothing for one that jumps.
///
/// Smallest use:
///     const auto curve = curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 0}}));
std::optional<PlaneCurve> curve_of_spline(BSpline spline);

}  // namespace mes

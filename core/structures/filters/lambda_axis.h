// SPDX-License-Identifier: GPL-3.0-or-later
// Lambda: how far apart the samples nearest to an axis point are.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/structures/filters/axis_filter.h"

namespace mes {

/// lambda(x) is the radius of the smallest circle that encloses the samples nearest to x. Along an edge of the axis
/// these are two, so lambda is half their distance. At a node it is the circumradius if the centre lies among the
/// samples of the circle, else half the largest distance between two of them.
///
/// Guarantees, besides those of `AxisFilter`: which values reach the limit, and the order of edges, are decided exactly
/// for the given doubles. A node's lambda is not below that of any edge at it.
///
/// Below the weak feature size of the shape, the smallest positive critical value of the distance to the curve, the
/// lambda axis has the homotopy type of the shape. `weak_feature_size` is the smallest critical value of the distance
/// to the *samples* on the axis: half the length of a Delaunay edge that its dual crosses (a saddle), or the radius of
/// a ball whose centre lies among its samples, in their closed convex hull. It is an estimate from the samples. If
/// there is no such point, as in a single obtuse triangle, it is infinite.
///
/// Source: Chazal and Lieutier, "The lambda-medial axis", Graphical Models 67, 2005.
class LambdaAxis final : public AxisFilter {
 public:
  LambdaAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
             MedialAxis& axis);

  double value(EdgeSlot edge) const override;
  double value(FaceSlot node) const override;
  std::string spoken(double value) const override;
  std::string_view measure() const override { return "lambda"; }
  /// Critical values of the distance to the samples on the axis, ascending, each once. Which edges and nodes are
  /// critical is decided exactly; their values are rounded, and values that round to one double count once.
  std::vector<double> critical_values() const;
  std::string_view kernel() const override { return "doubles with a proved bound, rationals"; }

 protected:
  bool reaches(EdgeSlot edge) const override;
  void reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const override;
  bool node_reaches(FaceSlot node) const override;
  int compare(EdgeSlot a, EdgeSlot b) const override;
  void add_statistics(StatList& out) const override;

 private:
  std::array<Vec2, 3> corners(FaceSlot face) const;
  /// The radius of a node whose centre lies among its samples.
  std::optional<double> critical_value(FaceSlot node) const;
};

}  // namespace mes

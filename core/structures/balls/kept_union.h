// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the shape is left of a filtered axis: the union of the balls along what a filter keeps.
#pragma once

#include "core/structures/balls/ball_union.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/lambda_axis.h"

namespace mes {

/// The balls of the kept nodes and those at cuts of edges, which hold all balls between; scaled by `a-scale`, as the inner
/// balls are.
///
/// `share_of_shape` is the area of the union over that of the shape, which is the union of all inner balls: the inside
/// triangles, and beyond each edge of the curve the segment of the ball behind it. Where samples are too far apart for
/// these segments to be disjoint, it is a little too small. At a limit that takes nothing away it is 1.
///
/// Rows of balls: face f has row 2f, and the piece of an axis end in row i of `AxisFilter` has row 2i + 1. Balls are
/// rounded; made anew for every change, by the general pipeline.
class KeptUnion : public BallUnion {
 public:
  StatList statistics() const override;
  /// It is only measured, and says nothing about the theorem.
  void find(std::vector<Finding>&) const override {}
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  KeptUnion(std::string_view id, SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls,
            AxisFilter& filter);

 private:
  double shape_area() const;

  const Delaunay& delaunay_;
  const Labels& labels_;
  const AxisFilter& filter_;
};

class LambdaUnion final : public KeptUnion {
 public:
  LambdaUnion(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls, LambdaAxis& filter)
      : KeptUnion("lambda-union", settings, delaunay, labels, balls, filter) {}
};
class AngleUnion final : public KeptUnion {
 public:
  AngleUnion(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls, AngleAxis& filter)
      : KeptUnion("angle-union", settings, delaunay, labels, balls, filter) {}
};
class CoverUnion final : public KeptUnion {
 public:
  CoverUnion(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls, CoverAxis& filter)
      : KeptUnion("cover-union", settings, delaunay, labels, balls, filter) {}
};

}  // namespace mes

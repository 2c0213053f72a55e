// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how much of the shape a filtered axis preserves: the union of the balls along its kept part.
#pragma once

#include "core/structures/balls/ball_union.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/lambda_axis.h"

namespace mes {

/// The balls of the kept nodes and those at cuts of edges, which hold all balls between; scaled by `a-scale`, like the
/// inner balls.
///
/// `shape_area` is the area of the shape, that is, of the inside triangles. `share_of_shape` is the share of it that
/// the union holds. A ball reaches beyond the shape in a circular segment behind each edge of the curve at its own
/// triangle. The segments of kept balls are subtracted, so the large ball of an open place counts only with its part of
/// the shape. At a limit that removes nothing the share is 1. It is an estimate in two respects: the part of a kept
/// ball beyond the edge of a triangle whose own ball is not kept is not subtracted, and where samples are so far apart
/// that segments overlap, too much is; results above 1 are set to 1. There is no share if balls are scaled, or so large
/// that their area has no digits left for the shape.
///
/// Rows of balls: face f has row 2f, and the piece of an axis end in row i of `AxisFilter` has row 2i + 1. Balls are
/// rounded; the general pipeline recomputes the union for every change.
class KeptUnion : public BallUnion {
 public:
  StatList statistics() const override;
  /// The union is only measured, and says nothing about the theorem.
  void find(std::vector<Finding>&) const override {}
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  KeptUnion(std::string_view id, SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls,
            AxisFilter& filter);

 private:
  /// Area of a kept ball beyond the edge opposite corner i of its triangle.
  double segment_area(const FaceRow& row, int i) const;

  const Delaunay& delaunay_;
  const Labels& labels_;
  const InnerBalls& balls_;
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

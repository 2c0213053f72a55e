// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axis transform: balls along the one-step axis are grown by a factor, and the medial axis of their union is
// computed; its radii are divided by the factor again.
#pragma once

#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/sampling/ball_halving.h"
#include "core/structures/balls/internal/sampling/scale_hairs.h"

namespace mes {

/// Balls between the ends of the edges of the one-step axis: inner Voronoi balls alone are too far apart on long edges,
/// and leave gaps when they are grown or shrunk.
///
/// Guarantees:
///  1. Each ball between is centred at a point of an axis edge, and touches the two samples of the edge. It lies in the
///     union of the balls at both ends of the edge.
///  2. An edge is halved until the circles at both ends of each part cross at `medial-sampling-angle` or more, or
///     twenty times. Below a factor of 1 the shrunk circles count, so that balls of an edge do not part unless one end
///     is a million times as large as the other.
///  3. There are at most `kMostBallsBetween`. If there would be more, neighbours may cross at 120 degrees where the
///     dents between them are no deeper than a *tolerance*: the least of 2^-29, 2^-27, ... 2^-11 of the samples'
///     diameter that suffices. `findings` reports it. If none suffices, the structure fails.
///  4. Edges with an end beyond the range of doubles have no balls; `not_finite` counts them.
///
/// Rows are owned by edges; each depends on its edge and the tolerance only. Updates take O(changed edges), or a
/// rebuild if a tolerance is or was needed. Decisions and radii are those of doubles.
class AxisSampling final : public Structure {
 public:
  AxisSampling(SettingsSource& settings, Delaunay& delaunay, MedialAxis& axis);

  const SampledBalls& between() const { return between_; }
  /// Calls `visit(row)` for all balls between that lie on the edge.
  template <class Visit>
  void for_each_on(EdgeSlot edge, Visit visit) const {
    between_.for_each_of(same_row<OwnerSlot>(edge), visit);
  }

  /// The distance of neighbouring balls of one size, where balls have this radius.
  double spacing(double radius) const;

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { between_.clear_changes(); }
  std::size_t touched() const override { return between_.changes().size(); }
  std::vector<std::string_view> parameters() const override {
    return {Parameter::medial_sampling_angle.id, Parameter::scale_axis_factor.id};
  }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void find(std::vector<Finding>& out) const override;

 private:
  struct Density {
    double angle = kNone;
    double shrinking = 1.0;  ///< factor of the balls that must cross at the angle; at most 1
    friend bool operator==(const Density&, const Density&) = default;
  };
  Density density() const;
  bool is_edge(EdgeSlot edge) const;
  /// Diameter of all positions where balls may be.
  double diameter() const;
  /// Makes the balls of all edges; false if there are too many.
  bool fill(JobControl& job);
  void remake(EdgeSlot edge);

  const SettingsSource& settings_;
  const Delaunay& delaunay_;
  const MedialAxis& axis_;
  static constexpr double kNone = -1.0;  // no balls between are wanted
  Density made_with_;
  BallHalving halving_;
  SampledBalls between_;
};

/// The union of the inner Voronoi balls and those of `AxisSampling`, with radii multiplied by `scale-axis-factor`.
///
/// At a factor of 1 the balls between add nothing to the union and are left out: it is the union of the inner balls, by
/// the certified shortcut where that holds. At other factors the general pipeline recomputes it for every change. Inner
/// Voronoi balls are grown as circumdisks of the samples, except where `fast` rounds the balls (`BallUnion`).
///
/// At other factors spurious branches (*hairs*) are cut off its axis (internal/scale_hairs.h). Where the boundary is
/// touched from one side only, each ball that has an arc of it makes a branch of its own: arcs between sampled balls
/// are scallops of a boundary that all balls of the axis would make smooth. Below 1 this happens at each bend of the
/// one-step axis, which is a polygon: the balls beside it cover the arc on the inside. The spacing of a Voronoi ball is
/// the larger of the longest edge of the curve behind which it has an arc, and the distance at which
/// `medial-sampling-angle` has equal balls of its radius; that of a ball between is the larger of this distance and the
/// spacings at the ends of its edge. Branches are cut, from free ends inwards, where their two nearest boundary points
/// are at most two spacings apart (within 0.02 of a factor of 1, the share |s - 1| / 0.02 of that) and are seen at less
/// than 60 degrees; decided with doubles, whatever the number type. Components and cycles are those of the grown union.
///
/// Loss at true ends: let e be the largest spacing of the balls there. A branch stays where its boundary points are
/// seen at 2 t or more, sin t = min(1/2, e / (s r)). A smooth end is then no shorter than at the factor s / cos t,
/// which is at most 1.16 s, and nearly s (1 + (e / (s r))^2 / 2) for small spacings; so below 0.86 it is whole. At a
/// factor of 1 nothing is cut.
///
/// Rows of balls: at a factor of 1 faces; otherwise face f has row 2f, and row i of `AxisSampling` has row 2i + 1.
/// Sources: Giesen, Miklos, Pauly and Wormser 2009; Miklos, Giesen and Pauly 2010 (balls that a slightly larger factor
/// covers are noise).
class ScaleUnion final : public BallUnion {
 public:
  ScaleUnion(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
             MedialAxis& axis, AxisSampling& sampling, AxisCertificate& certificate);
  void rebuild(JobControl& job) override;
  StatList statistics() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

  /// The factor that radii were multiplied by.
  double factor() const { return family().scale(); }

 private:
  void refine(UnionTables& tables) override;
  /// Spacing at each ball: of the samples, or of the balls along the axis.
  Table<FamilySlot, double> spacing() const;

  const Delaunay& delaunay_;
  const Labels& labels_;
  const InnerBalls& balls_;
  const AxisSampling& sampling_;
  ScaleHairs hairs_;
};

/// Explains the radii that a piece of the axis has before the balls grow.
void explain_divided_radii(const BallUnion& balls, AxisPieceSlot row, Explanation& out);

/// Balls along the axis of a union of grown balls, at their grown size.
class GrownBallSampling : public BallSampling {
 public:
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  GrownBallSampling(std::string_view id, SettingsSource& settings, BallUnion& balls)
      : BallSampling(id, settings, balls), balls_(balls) {}

 private:
  const BallUnion& balls_;
};

class ScaleBallSampling final : public GrownBallSampling {
 public:
  ScaleBallSampling(SettingsSource& settings, ScaleUnion& balls)
      : GrownBallSampling("scale-ball-sampling", settings, balls) {}
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axis transform: balls along the one-step axis are grown by a factor, and the medial axis of their union is
// taken; its radii are divided by the factor again.
#pragma once

#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/ball_halving.h"
#include "core/structures/balls/internal/scale_hairs.h"

namespace mes {

/// Balls between the ends of the edges of the one-step axis: inner Voronoi balls alone are too far apart on long edges,
/// and leave gaps between them when they are grown or shrunk.
///
/// What it guarantees:
///  1. A ball between lies about a point of an axis edge, and touches the two samples of the edge. It lies in the union
///     of the balls at both ends of the edge.
///  2. An edge is halved until the circles at both ends of each part cross at `medial-sampling-angle` or more, or twenty
///     times. Below a factor of 1 these are the shrunk circles, so that balls of an edge do not part unless one end is a
///     million times as large as the other.
///  3. There are at most `kMostBallsBetween`. If these were more, neighbours may cross at 120 degrees where the dents
///     between them are no deeper than a *tolerance*: the least of 2^-29, 2^-27, ... 2^-11 of the samples' diameter
///     that suffices. `findings` says so. If none suffices it fails.
///  4. Edges of which an end is beyond doubles have no balls; `not_finite` counts them.
///
/// Rows are owned by edges; each depends on its edge and the tolerance only. Updates O(changed edges), or a rebuild where
/// a tolerance is needed or was. Decisions and radii are those of doubles.
class AxisSampling final : public Structure {
 public:
  AxisSampling(SettingsSource& settings, Delaunay& delaunay, MedialAxis& axis);

  const SampledBalls& between() const { return between_; }
  /// `visit(row)` for all balls between that lie on the edge.
  template <class Visit>
  void for_each_on(EdgeSlot edge, Visit visit) const {
    between_.for_each_of(same_row<OwnerSlot>(edge), visit);
  }

  /// How far from each other neighbours are that are as large as the balls at a place where these have this radius.
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
    double shrinking = 1.0;  ///< of the balls that are to cross at the angle; at most 1
    friend bool operator==(const Density&, const Density&) = default;
  };
  Density density() const;
  bool is_edge(EdgeSlot edge) const;
  /// Of all places where balls may be.
  double diameter() const;
  /// Balls of all edges; false: there are too many.
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
/// the certified shortcut where that holds. At other factors it is made anew for every change, by the general pipeline.
/// Inner Voronoi balls are grown as circumdisks of the samples, but where `fast` rounds the balls (`BallUnion`).
///
/// At other factors *hairs* are taken off its axis (internal/scale_hairs.h). Where the boundary is touched from one side
/// only, each ball that has an arc of it makes a branch of its own: arcs between sampled balls are scallops of what would
/// be smooth for all balls of the axis. Below 1 it is so at each bend of the one-step axis, which is a polygon: the balls
/// beside it cover the arc on the inside. The spacing of a Voronoi ball is the longest edge of the curve behind which it has
/// an arc, or the distance at which `medial-sampling-angle` has equal balls of its radius, whichever is larger; that of a
/// ball between is the larger of this distance and the spacings at the ends of its edge. So branches go, from free ends
/// inwards, whose two nearest boundary points are no farther apart than two spacings, or the share |s - 1| / 0.02 of them
/// nearer to a factor of 1 than that, and are seen at less than 60 degrees: decided with doubles, whatever the number type.
/// Components and cycles are those of the grown union.
///
/// What true ends lose: with the largest spacing e of the balls there, a branch stays where its boundary points are seen
/// at 2 t or more, sin t = min(1/2, e / (s r)). A smooth end is then no shorter than at the factor s / cos t, which is at
/// most 1.16 s, and nearly s (1 + (e / (s r))^2 / 2) for small spacings; so below 0.86 it is whole. At a factor of 1
/// nothing goes.
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

  /// What radii were multiplied by.
  double factor() const { return family().scale(); }

 private:
  void refine(UnionTables& tables) override;
  /// Of the samples, or of the balls along the axis, at a ball.
  Table<FamilySlot, double> spacing() const;

  const Delaunay& delaunay_;
  const Labels& labels_;
  const InnerBalls& balls_;
  const AxisSampling& sampling_;
  ScaleHairs hairs_;
};

/// Says what the radii of a piece of the axis are before the balls grow.
void explain_divided_radii(const BallUnion& balls, AxisPieceSlot row, Explanation& out);

/// Balls along the axis of a union of grown balls, as large as they are there.
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

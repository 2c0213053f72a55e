// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axis transform: balls along the one-step axis are grown by a factor, and the medial axis of their union is
// taken; its radii are divided by the factor again.
#pragma once

#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/ball_halving.h"

namespace mes {

/// Balls between the ends of the edges of the one-step axis: inner Voronoi balls alone are too far apart on long edges,
/// and leave gaps between them when they are grown.
///
/// What it guarantees:
///  1. A ball between lies about a point of an axis edge, and touches the two samples of the edge. It lies in the union
///     of the balls at both ends of the edge.
///  2. An edge is halved until the circles at both ends of each part cross at `medial-sampling-angle` or more, or twenty
///     times.
///
/// Rows are owned by edges; each depends on its edge only. Updates O(changed edges). Decisions and radii are those of
/// doubles.
class AxisSampling final : public Structure {
 public:
  AxisSampling(SettingsSource& settings, Delaunay& delaunay, MedialAxis& axis);

  const SampledBalls& between() const { return between_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { between_.clear_changes(); }
  std::size_t touched() const override { return between_.changes().size(); }
  StatList statistics() const override;

 private:
  /// No balls between are wanted at a factor of 1.
  double angle() const {
    const ComputationSettings& settings = settings_.current();
    return settings[Parameter::scale_axis_factor] == 1.0 ? kNone : settings[Parameter::medial_sampling_angle];
  }
  void remake(EdgeSlot edge);

  const SettingsSource& settings_;
  const Delaunay& delaunay_;
  const MedialAxis& axis_;
  static constexpr double kNone = -1.0;
  double made_with_ = kNone;
  BallHalving halving_;
  SampledBalls between_;
};

/// The union of the inner Voronoi balls and those of `AxisSampling`, with radii multiplied by `scale-axis-factor`.
///
/// At a factor of 1 the balls between add nothing to the union and are left out: it is the union of the inner balls, by
/// the certified shortcut where that holds. At other factors it is made anew for every change, by the general pipeline.
/// In `fast` it is that of rounded balls, unless that contradicts itself, as where centres are in line; in `exact`, inner
/// Voronoi balls are grown as circumdisks of the samples.
///
/// Rows of balls: at a factor of 1 faces; otherwise face f has row 2f, and row i of `AxisSampling` has row 2i + 1.
/// Source: Giesen, Miklos, Pauly and Wormser 2009.
class ScaleUnion final : public BallUnion {
 public:
  ScaleUnion(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
             MedialAxis& axis, AxisSampling& sampling, AxisCertificate& certificate);
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

  /// What radii were multiplied by.
  double factor() const { return family().scale(); }

 private:
  bool is_exact_on_doubt() const override { return true; }
};

/// Balls along the axis of `ScaleUnion`, as large as they are there.
class ScaleBallSampling final : public BallSampling {
 public:
  ScaleBallSampling(SettingsSource& settings, ScaleUnion& balls)
      : BallSampling("scale-ball-sampling", settings, balls), balls_(balls) {}
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  const ScaleUnion& balls_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Object angle: half the angle between the two nearest samples, seen from an axis point.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/structures/filters/axis_filter.h"
#include "core/structures/filters/object_angle.h"

namespace mes {

/// The value that stands for an edge of the axis, along which the angle varies; the parameter `angle-mode`.
enum class AngleMode : std::uint8_t {
  clip,     ///< each point for itself: an edge is cut where the angle reaches the limit
  largest,  ///< the largest angle on the edge decides about all of it
  mean,     ///< the mean of the angles at its two ends decides about all of it
};

/// The angle at a node is the largest half angle between two samples of its circle. Values are degrees in [0, 90],
/// computed from differences of samples by `atan2` and compared as doubles.
///
/// Source: Dey and Zhao, "Approximate medial axis as a Voronoi subcomplex", 2002; Foskey, Lin and Manocha, "Efficient
/// computation of a simplified medial axis", 2003 (the theta-simplified axis, which `clip` is).
class AngleAxis final : public AxisFilter {
 public:
  AngleAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
            MedialAxis& axis);

  double value(EdgeSlot edge) const override;
  double value(FaceSlot node) const override;
  std::string spoken(double value) const override;
  std::string_view measure() const override { return "object_angle"; }
  std::vector<std::string_view> parameters() const override {
    return {Parameter::angle_limit.id, Parameter::keep_topology.id, Parameter::angle_mode.id};
  }
  AngleMode angle_mode() const { return static_cast<AngleMode>(wish().mode); }
  /// The largest angle on an edge of the axis, whatever the mode of the filter.
  double largest(EdgeSlot edge) const;
  /// The angle at the end `EdgeRow::f[end]` of an edge.
  double end_value(EdgeSlot edge, int end) const;

 protected:
  int mode(const ComputationSettings& settings) const override;
  void take(const Wish& wish) override;
  bool reaches(EdgeSlot edge) const override;
  Reached reached(EdgeSlot edge) const override;
  void reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const override;
  void begin_all() override;
  void end_all() override;
  Vec2 cut_place(EdgeSlot edge, int end) const override;
  bool node_reaches(FaceSlot node) const override;
  int compare(EdgeSlot a, EdgeSlot b) const override;
  void add_statistics(StatList& out) const override;

 private:
  double group_value(FaceSlot node) const;
  Reached reached(CornerBits at_p, CornerBits at_s) const;

  AngleLimit limit_{0.0};
  // Facts known about the corners of inside faces while everything is decided. Two per edge, that of its face with the
  // smaller row first; and one per face, for all its corners together.
  std::unique_ptr<CornerBits[]> corners_;
  std::unique_ptr<CornerBits[]> nodes_;
};

}  // namespace mes

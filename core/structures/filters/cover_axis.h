// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the axis whose balls are swallowed late when all inner balls grow.
#pragma once

#include "core/structures/filters/axis_filter.h"
#include "core/structures/filters/cover_dates.h"

namespace mes {

/// The limit is `scale-axis-factor`: a node is kept if no other inner ball, grown by a smaller factor, swallows its
/// ball grown by the same. An edge has the smaller cover date of its two ends. So one setting has two answers to the
/// question of what remains when balls grow: this filter, which removes parts of the axis, and the scale axis, which is
/// another axis.
///
/// Values are 1 - 1/s of the cover date s: 0 for balls that are swallowed at once, 1 for those that never are, which
/// every limit leaves.
///
/// Cost, besides that of `AxisFilter`: `CoverDates`, and a rebuild for every edit.
class CoverAxis final : public AxisFilter {
 public:
  CoverAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
            MedialAxis& axis, CoverDates& dates);

  double value(EdgeSlot edge) const override { return share_of(date(edge)); }
  double value(FaceSlot node) const override { return share_of(date(node)); }
  std::string spoken(double value) const override;
  std::string_view measure() const override { return "cover"; }

 protected:
  bool reaches(EdgeSlot edge) const override { return date(edge) >= wish().limit; }
  bool node_reaches(FaceSlot node) const override { return date(node) >= wish().limit; }
  int compare(EdgeSlot a, EdgeSlot b) const override;
  void add_statistics(StatList& out) const override;

 private:
  static double share_of(double date) { return 1.0 - 1.0 / date; }
  double date(FaceSlot node) const { return dates_.has_date(node) ? dates_.date(node) : 1.0; }
  double date(EdgeSlot edge) const;

  const CoverDates& dates_;
};

}  // namespace mes

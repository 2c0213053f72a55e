// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/cover_axis.h"

#include <algorithm>
#include <cmath>

namespace mes {

CoverAxis::CoverAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
                     InnerBalls& balls, MedialAxis& axis, CoverDates& dates)
    : AxisFilter("cover-axis", settings, delaunay, crust, labels, balls, axis, Parameter::scale_axis_factor, &dates),
      dates_(dates) {}

double CoverAxis::date(EdgeSlot edge) const {
  const FaceSlot* const face = delaunay_.edge(edge).f;
  return std::min(date(balls_.ball(face[0])), date(balls_.ball(face[1])));
}

int CoverAxis::compare(EdgeSlot a, EdgeSlot b) const {
  const double at_a = date(a);
  const double at_b = date(b);
  return at_a < at_b ? -1 : (at_b < at_a ? 1 : 0);
}

void CoverAxis::add_statistics(StatList& out) const {
  std::int64_t never = 0;
  for (const FaceSlot node : delaunay_.face_slots())
    if (delaunay_.face(node).is_alive() && axis_.is_node(node) && std::isinf(date(node))) ++never;
  out.push_back({"never_covered", never});
}

}  // namespace mes

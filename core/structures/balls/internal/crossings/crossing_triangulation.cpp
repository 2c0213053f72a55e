// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/crossings/crossing_triangulation.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "core/structures/triangulation/point_joiner.h"

namespace mes {

template <>
PointTriangulation point_triangulation<CrossingKernel>(const Table<InputSlot, CrossingPoint>& points,
                                                       JobControl& job) {
  using point_joiner::Joiner;
  PointTriangulation out;
  out.same_as.resize(points.size());
  std::unordered_map<const Crossing*, InputSlot> first;
  std::vector<InputSlot> order;
  for (const InputSlot i : points.rows()) {
    const auto [found, is_new] = first.emplace(points[i].at->same, i);
    out.same_as[i] = found->second;
    if (is_new) order.push_back(i);
  }
  const auto precedes = [&](InputSlot a, InputSlot b) {
    return CrossingKernel::Less_along()(points[a], points[b], false);
  };
  std::size_t looks = 0;
  std::ranges::sort(order, [&](InputSlot a, InputSlot b) {
    if ((++looks & 0xfffU) == 0) job.checkpoint();
    return precedes(a, b);
  });
  Table<point_joiner::PlaceSlot, Joiner<CrossingKernel>::Placed> distinct;
  distinct.reserve(order.size());
  for (const InputSlot i : order) {
    if (distinct.empty() || precedes(distinct.back().point, i)) {
      distinct.push_back({points[i], 0.0, i});
    } else {
      out.same_as[i] = distinct.back().point;
    }
  }
  for (const InputSlot i : points.rows()) out.same_as[i] = out.same_as[out.same_as[i]];
  out.dimension = distinct.empty() ? -1 : 0;
  if (distinct.size() < 2) return out;
  Joiner<CrossingKernel> joiner(std::move(distinct), false, job);
  joiner.run();
  joiner.extract(out);
  return out;
}

}  // namespace mes

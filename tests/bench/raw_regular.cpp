// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/raw_regular.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <vector>

namespace mes::bench {

std::size_t raw_regular_insert_range(std::span<const Disk> disks) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Weighted_point_2> points;
  points.reserve(disks.size());
  for (const Disk& disk : disks)
    points.emplace_back(Kernel::Point_2(disk.center.x, disk.center.y), disk.radius * disk.radius);
  CGAL::Regular_triangulation_2<Kernel> triangulation;
  triangulation.insert(points.begin(), points.end());
  return triangulation.number_of_vertices();
}

}  // namespace mes::bench

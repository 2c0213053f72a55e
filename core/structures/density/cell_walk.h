// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest axis edges, found by walking from Voronoi cell to Voronoi cell across the duals of crust edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/structures/crust/one_step_crust.h"
#include "core/structures/density/axis_line.h"

namespace mes {

/// Let x be the point of the axis that is nearest to a sample p. The segment from p to x meets no axis before x, so it
/// goes from cell to cell across the duals of crust edges only; and where it leaves the cell of a sample s, at y, s is no
/// farther from y than p is, so s is within twice |px| of p. A walk from the cell of p over crust edges, as far as twice
/// the least distance seen so far, therefore comes to a cell with x on its boundary. Cells lie in memory in the order
/// of the curve.
///
/// Distances are rounded, and of several edges at nearly the same distance the one that rounding makes nearest counts.
/// So the walk also crosses axis edges that are nearly as near as the best, and what it finds is the least of *all*
/// rounded distances, as a search through all edges would. A steep edge has an end of which only is known that it is far:
/// where that is farther than the samples reach, it does not matter; the other edges that are steep are looked at by every
/// sample.
///
/// Cost: building O(n); a search O(samples within twice the feature size, along the curve). Where these are many, a
/// search gives up.
/// Threads: searches may run side by side.
class CellWalk {
 public:
  /// `lines`: all edges of the axis.
  CellWalk(const Delaunay& delaunay, const OneStepCrust& crust, std::span<const AxisLine> lines, double unit);

  std::size_t cell_count() const { return sites_.size(); }
  /// Finds sizes for the samples of the cells [begin, end). Samples whose walk becomes too long are appended to
  /// `given_up`, and get no result.
  void search(std::size_t begin, std::size_t end, Table<SiteSlot, double>& squared,
              Table<SiteSlot, EdgeSlot>& nearest, std::vector<SiteSlot>& given_up) const;

 private:
  struct Group;
  struct Trail;
  struct AxisEntry {
    std::uint32_t line;
    std::uint32_t other;  ///< the cell on its other side
  };

  void order_cells(const Delaunay& delaunay, const OneStepCrust& crust);
  void list_lines(const Delaunay& delaunay);
  bool walk(Group& group, std::size_t begin, std::size_t end, Trail& trail) const;

  std::span<const AxisLine> lines_;
  std::vector<AxisEntry> vague_;  ///< edges with an end that may be anywhere
  bool has_steep_ = false;
  double reach_ = 0.0;           ///< four times the size of the box of all samples
  std::vector<SiteSlot> sites_;  ///< of the cells, in the order of the curve
  std::vector<Vec2> places_;     ///< in scaled units
  std::vector<double> reaches_;  ///< below it no axis edge of the cell is near the sample
  Table<SiteSlot, std::uint32_t> cell_of_;
  std::vector<std::uint32_t> first_crust_;
  std::vector<std::uint32_t> crust_;  ///< cells
  std::vector<std::uint32_t> first_line_;
  std::vector<AxisEntry> axis_;
};

}  // namespace mes

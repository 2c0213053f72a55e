// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest axis edges, found by walking from Voronoi cell to Voronoi cell across the duals of crust edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/density/axis_line.h"

namespace mes {

/// Let x be the point of the axis that is nearest to a sample p. The segment from p to x meets no axis before x, so it
/// goes from cell to cell across the duals of crust edges only. Where it leaves the cell of a sample s, at y, s is no
/// farther from y than p is, so s is within twice |px| of p. Therefore a walk from the cell of p over crust edges, as
/// far as twice the least distance seen so far, reaches a cell with x on its boundary. The sample s of that cell is no
/// farther from x than p is. So an axis edge can be skipped if it is farther from the samples of its cells than the
/// least distance seen so far.
///
/// Cells are ordered along the curve, in blocks of a few, and the walk goes from block to block; distant blocks are
/// skipped at once. A block lists the axis edges of its cells, each once, nearest to their samples first, so the walk
/// leaves it at the first edge that can be skipped.
///
/// Distances are rounded, and among edges at nearly the same distance the one with the least rounded distance counts.
/// So the walk also crosses axis edges that are nearly as near as the best, and finds the least of *all* rounded
/// distances, as a search through all edges would. A steep edge has an end that is only known to be far away. Where
/// that is farther than the samples reach, it does not matter; every sample looks at the other steep edges.
///
/// Cost: building O(n); a search O(blocks within twice the feature size, along the curve). Where these are many, a
/// search gives up, and does so later where few samples are left.
/// Threads: building borrows other cores; searches may run in parallel.
class CellWalk {
 public:
  CellWalk(const Delaunay& delaunay, const OneStepCrust& crust, double unit);

  /// Number of edges of the axis.
  std::size_t line_count() const { return line_count_; }
  /// Number of parts into which the searches are divided, independent of each other.
  std::size_t part_count() const;
  /// Finds sizes for the samples of a part. Samples whose walk becomes too long are appended to `given_up`, and get no
  /// result.
  void search(std::size_t part, Table<SiteSlot, double>& squared, Table<SiteSlot, EdgeSlot>& nearest,
              std::vector<SiteSlot>& given_up) const;
  /// The same for given-up samples of a part, in their order, by walks that may be many times as long. `given_up` keeps
  /// those without a result: after a few walks that become too long, the others do not begin. Throws `Cancelled`.
  void search_longer(std::vector<SiteSlot>& given_up, Table<SiteSlot, double>& squared,
                     Table<SiteSlot, EdgeSlot>& nearest, JobControl& job) const;

 private:
  struct Group;
  struct Trail;
  /// The axis edges and curve edges among a run of rows, which one task lists.
  struct Chunk;
  /// An edge of the axis, seen from a block with one of its two cells, or both.
  struct AxisEntry {
    std::uint32_t line = 0;
    std::uint32_t other = 0;  ///< the block of the other cell
    float reach = 0.0F;       ///< squared; no sample is nearer to the edge
  };
  /// Cells that are consecutive along the curve.
  struct Block {
    Box2 box;
    std::uint32_t first = 0;        ///< index of its first cell
    std::uint32_t first_entry = 0;  ///< index of its first axis edge; the nearest come first
    std::uint32_t first_link = 0;
  };

  void order_cells(const Delaunay& delaunay, const std::vector<Chunk>& chunks);
  void list_lines(const Delaunay& delaunay, const std::vector<Chunk>& chunks);
  void measure_blocks(const Delaunay& delaunay, double unit);
  static void sort_by_reach(std::span<AxisEntry> entries);
  std::span<const AxisEntry> entries_of(std::uint32_t block) const {
    return {entries_.get() + blocks_[block].first_entry, blocks_[block + 1].first_entry - blocks_[block].first_entry};
  }
  std::uint32_t end_of_group(std::uint32_t first, std::uint32_t block) const;
  bool search_group(std::uint32_t begin, std::uint32_t end, std::uint32_t block, Trail& trail,
                    Table<SiteSlot, double>& squared, Table<SiteSlot, EdgeSlot>& nearest) const;
  bool walk(Group& group, std::uint32_t own, Trail& trail) const;

  std::unique_ptr<AxisLine[]> lines_;  ///< in the order of the edges
  std::uint32_t line_count_ = 0;
  std::vector<AxisEntry> vague_;  ///< edges with an end at an unknown position
  bool has_steep_ = false;
  double reach_ = 0.0;           ///< four times the size of the box of all samples
  std::vector<SiteSlot> sites_;  ///< samples of the cells, in the order of the curve
  std::vector<Vec2> places_;     ///< positions of these samples, in scaled units
  Table<SiteSlot, std::uint32_t> block_of_;
  std::vector<Block> blocks_;  ///< with one more as a sentinel
  std::unique_ptr<AxisEntry[]> entries_;
  std::vector<std::uint32_t> links_;  ///< from block to block
};

}  // namespace mes

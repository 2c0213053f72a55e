// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/center_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/geometry/box2.h"

namespace mes {
namespace {

bool is_on_curve(const OneStepCrust& crust, EdgeSlot edge) {
  return crust.is_crust(edge) || crust.is_shared(edge);
}

Bank bank_at(const Delaunay& delaunay, const OneStepCrust& crust, SiteSlot site) {
  Bank out{delaunay.site_position(site)};
  out.neighbours.fill(out.sample);
  std::size_t count = 0;
  delaunay.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot /*left*/) {
    if (!is_on_curve(crust, edge)) return;
    if (count < 2) out.neighbours[count] = delaunay.site_position(other);
    ++count;
  });
  if (count > 2) out.neighbours.fill(out.sample);
  // Edges around a site have no fixed beginning, and the first of two equally near feet counts.
  std::ranges::sort(out.neighbours, lexicographically_less);
  return out;
}

/// The branches of a filter. Free ends that the filter cut have no node of the axis, and neither have closed branches.
/// Samples that nearly lie on one line enclose nothing, but have faces whose balls are far larger than all of them.
class FilteredNetwork final : public AxisNetwork {
 public:
  FilteredNetwork(const AxisFilter& filter, const OneStepCrust& crust, std::span<const AxisBranch> branches)
      : filter_(filter), crust_(crust), rows_(branches) {
    const Delaunay& delaunay = filter.delaunay();
    Box2 extent;
    for (const EdgeSlot edge : delaunay.edge_slots())
      if (const EdgeRow& row = delaunay.edge(edge); row.is_alive())
        for (const SiteSlot site : row.v) extent.add(delaunay.site_position(site));
    const double most = distance(extent.low, extent.high);
    for (const AxisBranch& branch : branches) {
      if (branch.radius_largest > most) continue;
      if (branch.edges.empty()) ++points_;
      if (branch.edges.empty() || !(branch.length > 0.0)) continue;
      const std::uint32_t from = node_of(branch.from, branch.edges.front());
      const std::uint32_t to =
          branch.from.kind == BranchEndKind::none ? from : node_of(branch.to, branch.edges.back());
      branches_.push_back({from, to, branch.length});
      row_of_.push_back(static_cast<std::size_t>(&branch - branches.data()));
    }
  }

  void append(std::size_t number, bool is_backwards, CenterLine& line) const override {
    const AxisBranch& branch = rows_[row_of_[number]];
    const Delaunay& delaunay = filter_.delaunay();
    const std::size_t n = branch.edges.size();
    for (std::size_t i = 0; i < n; ++i) {
      const EdgeSlot edge = branch.edges[is_backwards ? n - 1 - i : i];
      Vec2 begin = filter_.kept_end(edge, 0);
      Vec2 end = filter_.kept_end(edge, 1);
      // Ends of edges at one node may differ in their last bits.
      const Vec2 here = line.axis.back();
      if (distance(end, here) < distance(begin, here)) std::swap(begin, end);
      if (end == here) continue;
      std::array<Bank, 2> banks{bank_at(delaunay, crust_, delaunay.edge(edge).v[0]),
                                bank_at(delaunay, crust_, delaunay.edge(edge).v[1])};
      // The axis runs between its two samples, at a right angle to their difference.
      if (cross(end - begin, banks[0].sample - banks[1].sample) < 0.0) std::swap(banks[0], banks[1]);
      line.axis.push_back(end);
      line.banks.push_back(banks);
    }
  }

 private:
  std::uint32_t node_of(const AxisBranch::End& end, EdgeSlot edge) {
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    if (end.node != kNoSlot) {
      const auto [at, is_new] = number_of_.try_emplace(end.node.index(), next);
      if (!is_new) return at->second;
    }
    const Delaunay& delaunay = filter_.delaunay();
    return add_node(end.place, distance(end.place, delaunay.site_position(delaunay.edge(edge).v[0])));
  }

  const AxisFilter& filter_;
  const OneStepCrust& crust_;
  std::span<const AxisBranch> rows_;
  std::vector<std::size_t> row_of_;                         // of each branch of the network
  std::unordered_map<RowNumber, std::uint32_t> number_of_;  // of the nodes of the axis
};

}  // namespace

CenterLines center_lines_of(const AxisFilter& filter, const OneStepCrust& crust, std::span<const AxisBranch> branches,
                            const CenterLineRequest& request, JobControl& job) {
  return center_lines_of(FilteredNetwork(filter, crust, branches), request, job);
}

void extend_to_curve(CenterLines& set, const Delaunay& delaunay, const OneStepCrust& crust, double most) {
  std::vector<Wall> walls;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive() || !is_on_curve(crust, edge)) continue;
    walls.push_back({delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1])});
  }
  extend(set, walls, most);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The reconstructed curve: crust edges in order, as loops and open chains, with normals.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/crust/labels.h"

namespace mes {

using ChainSlot = Slot<struct ChainTag>;

/// Guarantees:
///  1. Every crust edge is in exactly one chain. Chains end at sites of degree other than two; what remains are
///     loops.
///  2. A chain whose edges all have the inside on the same side runs with the inside on its left: outer loops
///     counter-clockwise, holes clockwise. Any other starts at its lexicographically smaller end. Loops start at
///     their lexicographically smallest site.
///  3. A site of degree two has a unit normal, pointing outside where the chain has an inside: the normalised sum of
///     the unit normals of its two edges, or at a cusp where that sum vanishes the normal of the edge before it.
///
/// Cost: rebuild O(n); an update traces the chains through changed sites again, so O(length of those chains); its
/// change set holds only sites whose normal differs from before.
class Curve final : public Structure {
 public:
  struct Chain {
    bool closed = false;
    bool has_inside = false;      ///< the inside is on the left everywhere
    std::vector<SiteSlot> sites;  ///< in order; the first is not repeated when closed. Empty: the row is free
    std::vector<EdgeSlot> edges;  ///< edges[i] joins sites[i] and the next
  };

  Curve(Delaunay& delaunay, OneStepCrust& crust, Labels& labels);

  const Table<ChainSlot, Chain>& chains() const { return chains_; }
  bool has_normal(SiteSlot site) const {
    return normal_.has(site) && (normal_[site].x != 0.0 || normal_[site].y != 0.0);
  }
  /// Unit length; (0, 0) if the site has no normal.
  Vec2 normal(SiteSlot site) const { return normal_[site]; }
  /// Mean length of the two curve edges at a site with a normal.
  double spacing(SiteSlot site) const { return spacing_[site]; }

  /// Sites that moved, were added or removed, and those whose normal or spacing differs from before.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { site_changes_.clear(); }
  std::size_t touched() const override { return site_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  void trace_from(EdgeSlot edge);
  EdgeSlot other_crust_edge(SiteSlot site, EdgeSlot edge) const;
  SiteSlot other_end(EdgeSlot edge, SiteSlot site) const {
    const EdgeRow& row = delaunay_.edge(edge);
    return row.v[0] == site ? row.v[1] : row.v[0];
  }
  void orient(Chain& chain) const;
  void set_normals(const Chain& chain);
  void set_normal(SiteSlot site, Vec2 normal, double spacing);
  void dissolve(ChainSlot row);

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  Labels& labels_;
  Table<ChainSlot, Chain> chains_;
  std::vector<ChainSlot> free_chains_;
  Table<EdgeSlot, ChainSlot> chain_of_edge_;
  Table<SiteSlot, Vec2> normal_;
  Table<SiteSlot, double> spacing_;
  ChangeRecorder<SiteSlot> recorder_;
  ChangeSet<SiteSlot> site_changes_;
  std::vector<EdgeSlot> seeds_;
  // State of the current update:
  std::vector<SiteSlot> dissolved_;  ///< sites of chains that no longer exist
  SlotMarks<SiteSlot> has_new_normal_;
};

}  // namespace mes

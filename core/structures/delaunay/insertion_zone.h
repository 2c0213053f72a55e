// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a Delaunay triangulation that a new sample would replace.
//
// The faces that would go are those whose circle has the position inside: one region, found from the face that holds
// the position. The sample would be joined to all corners of that region. A face that is the outside of a hull edge
// goes if the position is beyond the edge, or on it.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/graph/explain.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// The faces that would go, and the edges around them.
class InsertionZone {
 public:
  /// A side of the region, counter-clockwise, with the face beyond it; one end may be at infinity.
  struct Side {
    SiteSlot from;
    SiteSlot to;
    EdgeSlot edge;  // kNoSlot if an end is at infinity
    FaceSlot beyond;
  };

  InsertionZone(const Delaunay& delaunay, Vec2 at, Explanation& out);
  /// False if a sample is there already.
  bool is_free() const { return !faces_.empty(); }
  const std::set<FaceSlot>& faces() const { return faces_; }
  /// Sides in their order around the region.
  const std::vector<Side>& sides() const { return sides_; }
  /// Edges between two faces that would go.
  const std::vector<EdgeSlot>& inner_edges() const { return inner_; }

 private:
  std::optional<FaceSlot> locate(Explanation& out) const;
  void collect(FaceSlot first, Explanation& out);
  void sort_sides();

  const Delaunay& delaunay_;
  Vec2 at_;
  std::set<FaceSlot> faces_;
  std::vector<Side> sides_;
  std::vector<EdgeSlot> inner_;
};

}  // namespace mes

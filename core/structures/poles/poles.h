// SPDX-License-Identifier: GPL-3.0-or-later
// The poles of the samples: the farthest Voronoi vertices of their cells, on either side of the curve.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/disk.h"
#include "core/graph/structure.h"
#include "core/kernel/pole_predicates.h"
#include "core/structures/crust/voronoi_vertices.h"

namespace mes {

/// Stands for a Voronoi vertex at infinity.
inline constexpr FaceSlot kInfinitePole{0xfffffffeU};

/// Guarantees:
///  1. `plus(site)` is the Voronoi vertex farthest from the site among those of its cell; `kInfinitePole` for a hull
///     site, in the direction of the sum of the outward unit normals of its two hull edges.
///  2. `minus(site)` is the farthest one on the other side of the site, seen from `plus`; kNoSlot if there is none, as
///     happens where samples are too few.
///  3. Decisions are exact for the given doubles. Of two equally far vertices, the lexicographically smaller counts.
///  4. Below dimension 2 there are no poles.
///
/// Rows: a Voronoi vertex is the Delaunay face that `VoronoiVertices` names for its circle. Cost: rebuild O(n), updates
/// O(faces around the change). Source: Amenta, Bern and Eppstein 1998.
class Poles final : public Structure {
 public:
  Poles(Delaunay& delaunay, VoronoiVertices& vertices);

  /// Returns a face, `kInfinitePole`, or kNoSlot.
  FaceSlot plus(SiteSlot site) const { return plus_[site]; }
  FaceSlot minus(SiteSlot site) const { return minus_[site]; }
  /// True if the face's circumcentre is a pole of some site, and the face stands for its circle.
  bool is_pole(FaceSlot face) const { return uses_[face] != 0; }
  /// Unit vector towards a pole at infinity.
  Vec2 direction_to_infinity(SiteSlot site) const;

  /// Faces that are new, or became or ceased to be poles. Never empty if anything about poles changed.
  const ChangeSet<FaceSlot>& face_changes() const { return face_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { face_changes_.clear(); }
  std::size_t touched() const override { return face_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "doubles with a proved bound, integers, rationals"; }
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  struct HullNeighbours {
    SiteSlot before;  ///< kNoSlot for inner sites
    SiteSlot after;
  };
  void explain_site(SiteSlot site, Explanation& out) const;
  void explain_vertex(FaceSlot face, Explanation& out) const;
  HullNeighbours hull_neighbours(SiteSlot site) const;
  /// Collects the finite faces around the site in `star_`.
  HullNeighbours gather_star(SiteSlot site);
  void find_poles(SiteSlot site);
  void use(FaceSlot pole, int change);
  void assign(SiteSlot site, FaceSlot plus, FaceSlot minus);

  Delaunay& delaunay_;
  VoronoiVertices& vertices_;
  Table<SiteSlot, FaceSlot> plus_;
  Table<SiteSlot, FaceSlot> minus_;
  Table<FaceSlot, std::uint32_t> uses_;
  ChangeRecorder<FaceSlot> recorder_;
  ChangeSet<FaceSlot> face_changes_;
  bool is_recording_ = false;

  // Work space.
  struct StarFace {
    FaceSlot face;
    StarTriangle triangle;
    RadiusKey key;
  };
  std::vector<StarFace> star_;
  std::vector<SiteSlot> sites_;
  SlotMarks<SiteSlot> site_marks_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha complexes of the samples for all radii at once: when each edge and triangle enters, and which components
// and holes are born and die.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/graph/structure.h"
#include "core/kernel/circle_order.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// The alpha complex of radius r holds a Delaunay edge or triangle if the disks of radius r about its corners and the
/// Voronoi cells of its corners have a point in common, that is, if its smallest empty circle has at most this radius.
/// It has the homotopy type of the union of these disks. That union is additive growth of balls of radius 0: radii grow
/// from 0 to r as sqrt(0 + r^2).
///
/// Guarantees:
///  1. Simplices that enter at the same radius, as a real number, have the same *rank*; different ranks have the order
///     of their radii. Rank 0 is the radius 0, at which the samples enter.
///  2. The edges and triangles at which pairs are born and die are a function of the sites: among simplices of one rank
///     and dimension, lexicographically smaller corners come first. Pairs without a lifetime are left out.
///  3. `radius` is the least double that is not smaller than the true radius: at this parameter, its simplices are in.
///
/// Cost: O(n log n), a few times that of the triangulation, and more where most radii are equal or nearly so, as on a
/// lattice or on one circle; every update recomputes all. Rows are those of `Delaunay`.
/// Source: Edelsbrunner, Kirkpatrick and Seidel 1983; Edelsbrunner, Letscher and Zomorodian 2002.
class AlphaFiltration final : public Structure {
 public:
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  explicit AlphaFiltration(Delaunay& delaunay);

  std::uint32_t rank(EdgeSlot edge) const { return edge_rank_[edge]; }
  /// The face must be finite.
  std::uint32_t rank(FaceSlot face) const { return face_rank_[face]; }
  std::size_t rank_count() const { return radius_.size(); }
  double radius(std::uint32_t rank) const { return radius_[rank]; }
  /// The largest rank whose radius is at most `r`, exactly. `r` is not negative.
  std::uint32_t last_rank(double r) const;

  /// Edges and faces in the order in which they enter.
  const std::vector<EdgeSlot>& edges() const { return edges_; }
  const std::vector<FaceSlot>& faces() const { return faces_; }

  /// A component of the union, or a hole in it.
  struct Class {
    bool is_hole = false;
    std::uint32_t birth = 0;       ///< rank of its birth
    std::uint32_t death = kNever;  ///< rank of its death; `kNever` if it stays
    SiteSlot site{};               ///< for a component: the site where it is born
    EdgeSlot edge{};               ///< joins the component to an older one, or closes the hole; kNoSlot if it stays
    FaceSlot face{};               ///< for a hole: the face that fills it
  };
  const std::vector<Class>& classes() const { return classes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "doubles with a proved bound, rationals"; }

 private:
  /// The triangle that the edge enters with, because its third corner is in the smallest circle around both ends;
  /// kNoSlot if the edge enters by itself.
  FaceSlot comes_with(EdgeSlot edge) const;
  void find_ranks(JobControl& job);
  void find_order();
  void find_classes();

  const Delaunay& delaunay_;
  Table<EdgeSlot, std::uint32_t> edge_rank_;
  Table<FaceSlot, std::uint32_t> face_rank_;
  std::vector<double> radius_;
  std::vector<EdgeSlot> edges_;
  std::vector<FaceSlot> faces_;
  std::vector<Class> classes_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Births and deaths of components and holes in a filtration of a plane triangulation.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace mes {

/// A triangulation of part of the plane whose simplices enter one after the other. The rank of a simplex says when it
/// enters; no simplex enters before its faces. Among simplices of one rank, corners come first, then edges, then
/// triangles; among corners and among triangles, the smaller `place` comes first.
struct PlaneFiltration {
  static constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();

  struct Simplex {
    std::uint32_t rank = 0;
    std::uint32_t place = 0;  ///< index in the order of its dimension; a permutation in which ranks do not decrease
  };
  struct Edge {
    std::uint32_t rank = 0;
    std::uint32_t end[2]{};
    std::uint32_t side[2]{kOutside, kOutside};  ///< triangles; `kOutside` if there is no triangle
  };
  std::vector<Simplex> corners;
  std::vector<Edge> edges;  ///< in the order in which they enter
  std::vector<Simplex> triangles;
};

/// A persistence pair: a component, born with a corner and killed by an edge that joins it to an older one; or a hole,
/// born with an edge and killed by the triangle that fills it.
struct PersistentClass {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  bool is_hole = false;
  std::uint32_t born_with = 0;   ///< corner or edge
  std::uint32_t dies_with = 0;   ///< edge or triangle; `kNever` if it stays
  std::uint32_t birth = 0;       ///< rank
  std::uint32_t death = kNever;  ///< rank

  friend bool operator==(const PersistentClass&, const PersistentClass&) = default;
};

/// The pairs whose birth and death have different ranks: components in the order of their deaths, then holes in the
/// reverse order of their births, then components that stay.
///
/// Where two components join, the one whose corner came later dies. Holes are found by duality, backwards: removing a
/// triangle leaves a new uncovered region, and removing an edge joins two regions. Of these, the one whose triangle
/// came earlier ends; the outside never does. So neither needs a matrix reduction.
/// Cost: near linear. Throws nothing but `std::bad_alloc`.
/// Source: Edelsbrunner, Letscher and Zomorodian 2002; holes by duality as in Delfinado and Edelsbrunner 1995.
///
/// Smallest use:
///     PlaneFiltration plane;
///     plane.corners = {{0, 0}, {0, 1}, {0, 2}};
///     const std::uint32_t none = PlaneFiltration::kOutside;
///     plane.edges = {{1, {0, 1}, {0, none}}, {1, {1, 2}, {0, none}}, {2, {0, 2}, {0, none}}};
///     plane.triangles = {{3, 0}};
///     const std::vector<PersistentClass> classes = persistent_classes(plane);
///     // Two components that die at 1, a hole from 2 to 3, and a component that stays.
std::vector<PersistentClass> persistent_classes(const PlaneFiltration& plane);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The one-step crust test and its kin: exact signs of polynomials in the coordinates of a Delaunay edge's two
// triangles.
//
// For an edge from q to r with apex p on its left and s on its right, let alpha and beta be the angles at p and s.
// With
//     D_p = (q-p).(r-p)   X_p = det(q-p, r-p)   D_s = (r-s).(q-s)   X_s = det(r-s, q-s)
// the edge's *phase* is the complex number (D_p + i X_p)(D_s + i X_s) = H + i I, a positive multiple of
// exp(i (alpha + beta)):
//     H >= 0  <=>  alpha + beta <= 90 degrees  <=>  crust edge
//     I >= 0  <=>  Delaunay;  I = 0  <=>  p, q, r, s cocircular, the dual Voronoi edge has length zero
// A hull edge has its apex s at infinity: beta = 0, H = D_p, I = X_p.
// Swapping (p, q, r, s) to (s, r, q, p) changes nothing. H and I are homogeneous of degree 4 (2 on the hull).
// Source: Gold and Snoeyink 2001; the polynomial form is ours.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Corners around a Delaunay edge: apex `p` to the left of q -> r, apex `s` to the right of it, missing on the hull.
struct EdgeCorners {
  Vec2 p, q, r;
  std::optional<Vec2> s;
};

/// Numbers of calls by the stage of the filter that decided.
struct FilterCounts {
  std::uint64_t static_filter = 0;
  std::uint64_t interval = 0;
  std::uint64_t exact = 0;

  FilterCounts& operator+=(const FilterCounts& other) {
    static_filter += other.static_filter;
    interval += other.interval;
    exact += other.exact;
    return *this;
  }
};

struct EdgeClass {
  bool is_crust = false;       ///< alpha + beta <= 90 degrees, ties included
  bool is_cocircular = false;  ///< the dual has length zero; always false on the hull
};

/// H and I in doubles.
struct Phase {
  double h = 0.0;
  double i = 0.0;
};
inline Phase phase_of(const EdgeCorners& e) {
  const Vec2 pq = e.q - e.p;
  const Vec2 pr = e.r - e.p;
  const double dp = dot(pq, pr);
  const double xp = cross(pq, pr);
  if (!e.s) return {dp, xp};
  const Vec2 sr = e.r - *e.s;
  const Vec2 sq = e.q - *e.s;
  const double ds = dot(sr, sq);
  const double xs = cross(sr, sq);
  return {dp * ds - xp * xs, xp * ds + dp * xs};
}

/// Exact signs for the given doubles, whatever their size.
EdgeClass classify_edge(const EdgeCorners& corners, FilterCounts& counts);

/// cos(alpha + beta) in [-1, 1], computed in doubles: the confidence of the crust test. For colours and display.
double edge_confidence(const EdgeCorners& corners);

/// Approximate sort key for `compare_ambiguity`: two keys that differ by more than `kAmbiguityKeyError` are in the
/// exact order. Increases with |cos(alpha + beta)|.
double ambiguity_key(const EdgeCorners& corners);
inline constexpr double kAmbiguityKeyError = 1e-13;

/// Exact order of |cot(alpha + beta)|: -1, 0 or 1. Edges with I = 0 are infinitely certain and compare equal to each
/// other.
int compare_ambiguity(const EdgeCorners& a, const EdgeCorners& b);

/// The ranks of Delaunay edges in that order, from 0; edges that compare equal share a rank. O(n log n), quicker than by
/// comparisons alone: the polynomials of an edge are evaluated once. Calls `checkpoint` now and then, which may throw.
std::vector<std::uint32_t> ambiguity_places(std::span<const EdgeCorners> edges,
                                            const std::function<void()>& checkpoint);

/// Exact order of the lengths |ab| and |cd|: -1, 0 or 1.
int compare_lengths(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_order.h"

#include <utility>

#include "core/base/parallel.h"

namespace mes {

namespace {

std::pair<Vec2, Vec2> sorted_ends(const Delaunay& delaunay, EdgeSlot edge) {
  const Vec2 a = delaunay.site_position(delaunay.edge(edge).v[0]);
  const Vec2 b = delaunay.site_position(delaunay.edge(edge).v[1]);
  return lexicographically_less(b, a) ? std::pair(b, a) : std::pair(a, b);
}

}  // namespace

void CertaintyOrder::find_keys() {
  Table<EdgeSlot, double> keys(delaunay_.edge_rows(), 0.0);
  parallel_for(keys.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end))
      if (delaunay_.edge(edge).is_alive()) keys[edge] = rank_of(edge).key;
  });
  keys_ = std::move(keys);
}

bool CertaintyOrder::mends(EdgeSlot edge) const {
  const SiteSlot* end = delaunay_.edge(edge).v;
  if (!crust_.is_odd(end[0]) || !crust_.is_odd(end[1])) return false;
  // Which diagonals cocircular sites have is chance, and their triangles are one ball: never between different
  // labels.
  if (crust_.is_cocircular(edge)) return false;
  if (crust_.is_crust(edge)) return crust_.degree(end[0]) >= 3 && crust_.degree(end[1]) >= 3;
  return crust_.degree(end[0]) == 1 && crust_.degree(end[1]) == 1;
}

bool CertaintyOrder::is_surer_by_exact_test(const Rank& a, const Rank& b) const {
  int order = 0;
  if (a.key < 0.0) {
    const SiteSlot* of_a = delaunay_.edge(a.edge).v;
    const SiteSlot* of_b = delaunay_.edge(b.edge).v;
    order = compare_lengths(delaunay_.site_position(of_a[0]), delaunay_.site_position(of_a[1]),
                            delaunay_.site_position(of_b[0]), delaunay_.site_position(of_b[1]));
  } else {
    order = compare_ambiguity(crust_.corners(a.edge), crust_.corners(b.edge));
  }
  if (order != 0) return order > 0;
  const auto [a_low, a_high] = sorted_ends(delaunay_, a.edge);
  const auto [b_low, b_high] = sorted_ends(delaunay_, b.edge);
  if (a_low != b_low) return lexicographically_less(b_low, a_low);
  return lexicographically_less(b_high, a_high);
}

}  // namespace mes

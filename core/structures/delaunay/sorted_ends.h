// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// The ends of an edge in lexicographic order, which does not depend on the order in which the sites were inserted.
inline std::array<Vec2, 2> sorted_ends(const Delaunay& delaunay, EdgeSlot edge) {
  const SiteSlot* const end = delaunay.edge(edge).v;
  const Vec2 a = delaunay.site_position(end[0]);
  const Vec2 b = delaunay.site_position(end[1]);
  return lexicographically_less(b, a) ? std::array{b, a} : std::array{a, b};
}

}  // namespace mes

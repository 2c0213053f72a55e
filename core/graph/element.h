// SPDX-License-Identifier: GPL-3.0-or-later
// Elements: rows of structures, for code that treats all kinds of rows alike.
#pragma once

#include <cstdint>

#include "core/base/ids.h"

namespace mes {

class Structure;

/// The kind of rows that a part of a layer draws.
enum class ElementKind : std::uint8_t {
  other,  ///< only the shape is known
  sample,
  site,
  voronoi_vertex,  ///< Delaunay face
  delaunay_edge,   ///< edge with its dual Voronoi edge
  own_ball,        ///< a ball of the document
  ball,            ///< a ball of a union
  dual_edge,
  dual_face,
  v_point,
  v_origin,
  axis_piece,
  v_face,
  v_edge,
  boundary_arc,
  power_edge,
  contour_link,  ///< between neighbours on a contour of the document
  sampled_ball,  ///< a ball along an axis
  // Elements of the complex of disks or balls that grow additively.
  alpha_corner,
  alpha_edge,
  alpha_triangle,
  alpha_end,    ///< end of an edge, with the arc that begins there
  alpha_class,  ///< a component or a hole
};

struct ElementType {
  ElementKind kind = ElementKind::other;
  const Structure* owner = nullptr;  ///< owner of the rows, if several structures have rows of this kind
};

struct Element {
  ElementType type;
  RowNumber row = 0xffffffffU;
};

}  // namespace mes

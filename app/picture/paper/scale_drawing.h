// SPDX-License-Identifier: GPL-3.0-or-later
// A scale bar, axes with numbers, and a grid, for a part of the plane.
//
// Smallest use:
//     const PaperDrawing marks = layout_scale_marks({.bar = true}, seen_plane(camera, 1.0), measure, kWhiteCanvas);
//     paint(image, fonts, marks, {0.0, 0.0}, 1.0);
//
// Cost: microseconds. Threads: any.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/picture/paper/paper_drawing.h"
#include "app/settings/scale_marks.h"
#include "core/base/geometry/box2.h"
#include "render/camera.h"
#include "render/figure/figure_of.h"

namespace mes {

class Document;

/// The part of the plane behind a drawing; the drawing has its size in logical pixels.
struct SeenPlane {
  Vec2 center{};
  double units_per_pixel = 1.0;  ///< units per logical pixel
  double width = 0.0;
  double height = 0.0;
  double covered = 0.0;        ///< height of anything over the lower end, such as a caption
  double covered_above = 0.0;  ///< height of anything over the upper end, such as a title
  std::string unit{};          ///< follows the number of the scale bar; empty: none
};
/// The unit of lengths in a document, such as "m" for a map in metres; empty without a map.
std::string unit_of_lengths(const Document& document);
/// `scale`: pixels, or units of 1/96 inch, per logical pixel.
SeenPlane seen_plane(const render::Camera& camera, double scale);
SeenPlane seen_plane(const figure::Page& page, double scale);
/// The part of the plane covered by a box on the drawing.
Box2 below(const SeenPlane& plane, const Box2& box);

/// The bar is in the lower left corner unless it has another position, and at most a quarter of the width; the axes
/// are the lower and the left edge; the grid has lines at the same numbers. Positions exclude the covered ends and
/// the axes. The numbers are round, and each differs from its neighbours; if doubles cannot distinguish them, as in a
/// deep zoom far from the origin, there are no numbers. Numbers that would overlap or leave the drawing are left out.
PaperDrawing layout_scale_marks(const ScaleMarks& marks, const SeenPlane& plane, const MeasureText& measure,
                                const std::optional<Rgb>& background);

/// The distance of grid lines, in units.
double grid_step(double units_per_pixel);
/// The largest such number that is at most a pixel, or the one before it.
double pixel_step(double units_per_pixel);

/// The positions of the marks, in logical pixels.
struct MarksPlace {
  std::optional<Box2> bar;  ///< includes its number; nothing: no bar
  /// The area of the bar with number and paper at its longest, so that nothing beside it moves with the scale.
  std::optional<Box2> longest_bar;
  Box2 room;  ///< the free area, where bar and legend can be placed
};
MarksPlace place_of_marks(const ScaleMarks& marks, const SeenPlane& plane, const MeasureText& measure);

/// The same marks with a position for the scale bar, if it has none: the corner whose box gives the least by `hides`; of
/// equal ones the first of lower left, lower right, upper left, upper right. Not for a sequence of pictures, in which
/// the bar must not move.
ScaleMarks with_free_bar(ScaleMarks marks, const SeenPlane& plane, const MeasureText& measure,
                         const std::function<std::pair<std::size_t, std::size_t>(const Box2&)>& hides);

/// The height in logical pixels that axes take at the lower edge.
inline constexpr double kAxisRoom = 26.0;
/// The width that they take at the left edge, with numbers of four digits and a sign.
inline constexpr double kAxisRoomBeside = 46.0;

}  // namespace mes

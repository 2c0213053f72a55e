// SPDX-License-Identifier: GPL-3.0-or-later
// Paints lines, arcs and polygons on a picture in memory, for annotations.
//
// Guarantees: the same shapes yield the same pixels, with neither a display nor OpenGL. Edges are antialiased.
// Parts outside the picture are left out; shapes with coordinates that are not finite are not painted.
//
// Cost: O(pixels of the bounding box within the picture). Threads: any, with a picture of its own.
#pragma once

#include <span>

#include "core/base/color.h"
#include "core/base/geometry/vec2.h"
#include "render/image/image.h"

namespace mes::render {

/// Coordinates are pixels from the upper left corner, y down. Ends and corners are round.
void stroke_path(Image& image, std::span<const Vec2> points, double width, Rgb color);

/// Starts at the angle `from`, in radians from the x axis towards y (clockwise on screen), and turns by `sweep`.
void stroke_arc(Image& image, Vec2 center, double radius, double from, double sweep, double width, Rgb color);

void fill_polygon(Image& image, std::span<const Vec2> corners, Rgb color);

}  // namespace mes::render

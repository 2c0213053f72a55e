// SPDX-License-Identifier: GPL-3.0-or-later
// Circles, arcs and parabolas as cubic Bezier curves, for formats that have no other curves.
#pragma once

#include <vector>

#include "core/base/geometry/vec2.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// A cubic curve that starts at the end of the previous one.
struct Bezier {
  Vec2 first_handle;
  Vec2 second_handle;
  Vec2 end;
};

/// The curves of an arc, enough of them for an error below a step of the figure's grid; the last one ends at its end.
std::vector<Bezier> arc_curves(const Shape& arc, int decimals);

/// The curve of a parabola, which is exact.
Bezier parabola_curve(const Shape& parabola);

/// The same as `arc_curves` for a circle or disk, starting at its rightmost point, counter-clockwise on screen.
std::vector<Bezier> circle_curves(const Shape& circle, int decimals);

}  // namespace mes::figure

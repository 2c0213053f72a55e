// SPDX-License-Identifier: GPL-3.0-or-later
// Circles and arcs as Bezier curves, for formats that have no other curves.
#pragma once

#include <vector>

#include "core/base/vec2.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// A cubic curve from where the one before ended.
struct Bezier {
  Vec2 first_handle;
  Vec2 second_handle;
  Vec2 end;
};

/// As many curves as it takes to stay within a step of the figure's grid of an arc; the last one ends at its end.
std::vector<Bezier> arc_curves(const Shape& arc, int decimals);

/// The same for a circle or disk, from its rightmost point around counter-clockwise as seen.
std::vector<Bezier> circle_curves(const Shape& circle, int decimals);

}  // namespace mes::figure

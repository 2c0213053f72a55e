// SPDX-License-Identifier: GPL-3.0-or-later
// The position of texts that appear over the canvas for a while: where they hide least.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>

#include "core/base/geometry/box2.h"

namespace mes {

/// The area for texts on the screen.
struct NoteRoom {
  Box2 area;
  /// Returns how much of the drawing and its marks a box on the screen would hide.
  std::function<std::size_t(const Box2&)> hides;
};

/// A place in the area: 0 is the left or upper edge, 1 the right or lower one.
struct NotePlace {
  float across = 0.5F;
  float down = 0.0F;

  /// The upper left corner of a text of this size.
  Vec2 corner(const Box2& area, Vec2 size) const {
    const Vec2 rest = area.high - area.low - size;
    return area.low + Vec2{across * rest.x, down * rest.y};
  }
};

/// The first of the places at which a text of this size hides least; there is at least one.
inline NotePlace least_hiding(const NoteRoom& room, Vec2 size, std::initializer_list<NotePlace> places) {
  NotePlace out = *places.begin();
  std::size_t least = static_cast<std::size_t>(-1);
  for (const NotePlace place : places) {
    const Vec2 low = place.corner(room.area, size);
    const std::size_t hidden = room.hides({low, low + size});
    if (hidden >= least) continue;
    least = hidden;
    out = place;
  }
  return out;
}

}  // namespace mes

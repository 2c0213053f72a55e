// SPDX-License-Identifier: GPL-3.0-or-later
// The handles of a frame around points, and the effect of dragging one of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"

namespace mes {

enum class Handle : std::uint8_t {
  left,
  right,
  bottom,
  top,
  lower_left,
  lower_right,
  upper_left,
  upper_right,
  turn,  ///< rotates; above the frame
};
inline constexpr std::size_t kHandles = 9;

/// The frame around a box. A margin keeps its handles off the points. Lengths are in units of the points.
///
/// Smallest use:
///     const HandleFrame frame(box, units_per_pixel);
///     if (const auto handle = frame.handle_at(pointer, 8.0 * units_per_pixel))
///       places = dragged(places, box, {*handle, held_place(box, *handle), to}).value().places;
class HandleFrame {
 public:
  HandleFrame(const Box2& box, double units_per_pixel);

  const Box2& outline() const { return outline_; }
  /// A box of zero width has no handles that would change the width, and likewise for its height.
  bool has(Handle handle) const;
  Vec2 at(Handle handle) const;
  /// The nearest handle within reach.
  std::optional<Handle> handle_at(Vec2 p, double reach) const;

 private:
  Box2 box_;
  Box2 outline_;
  double units_per_pixel_;
};

/// The point of the box that a handle holds: a corner, or the middle of a side (for `turn`, of the upper side).
Vec2 held_place(const Box2& box, Handle handle);

struct HandleDrag {
  Handle handle = Handle::turn;
  Vec2 from{};                ///< `turn`: start of the drag; otherwise the point that the handle holds
  Vec2 to{};                  ///< its new position
  bool about_middle = false;  ///< the middle of the box stays fixed, instead of the opposite side or corner
  bool in_steps = false;      ///< `turn`: in multiples of 15 degrees
};

struct Dragged {
  std::vector<Vec2> places;
  Vec2 factor{1.0, 1.0};  ///< for differences in x and y; negative: mirrored
  double degrees = 0.0;   ///< counter-clockwise
  /// For radii: the factor of corner handles; side handles change only centres.
  double radius_factor = 1.0;
};

/// Sides scale in their direction, and mirror when they are dragged across the fixed point; corners scale both
/// coordinates by one factor; `turn` rotates about the middle of the box. Points that share a coordinate with the held
/// point get exactly that of `to`. Returns nothing for a factor of zero.
std::optional<Dragged> dragged(std::span<const Vec2> places, const Box2& box, const HandleDrag& drag);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The handles of a frame around places: what dragging one does to the places.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/box2.h"
#include "core/base/vec2.h"

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
  turn,  ///< above the frame
};
inline constexpr std::size_t kHandles = 9;

/// The frame around a box, a margin away from it, so that handles do not lie on the places. In units of the places.
///
/// Smallest use:
///     const HandleFrame frame(box, units_per_pixel);
///     if (const auto handle = frame.handle_at(pointer, 8.0 * units_per_pixel))
///       places = dragged(places, box, {*handle, held_place(box, *handle), to}).value().places;
class HandleFrame {
 public:
  HandleFrame(const Box2& box, double units_per_pixel);

  const Box2& outline() const { return outline_; }
  /// A box without a width has no handles that change it, and likewise for its height.
  bool has(Handle handle) const;
  Vec2 at(Handle handle) const;
  /// The nearest one within reach.
  std::optional<Handle> handle_at(Vec2 p, double reach) const;

 private:
  Box2 box_;
  Box2 outline_;
  double units_per_pixel_;
};

/// What of the box a handle holds: a corner, the middle of a side, or for `turn` the middle of the upper side.
Vec2 held_place(const Box2& box, Handle handle);

struct HandleDrag {
  Handle handle = Handle::turn;
  Vec2 from{};                ///< `turn`: where the drag began; else what the handle holds
  Vec2 to{};                  ///< where that is to be now
  bool about_middle = false;  ///< what stays is the middle of the box, not its opposite side or corner
  bool in_steps = false;      ///< `turn`: by multiples of 15 degrees
};

struct Dragged {
  std::vector<Vec2> places;
  Vec2 factor{1.0, 1.0};  ///< of differences in x and y; below zero: mirrored
  double degrees = 0.0;   ///< counter-clockwise
  /// Of radii: the factor of corners, for sides change centres only.
  double radius_factor = 1.0;
};

/// Sides scale in their direction, and mirror when they are dragged across what stays; corners scale both coordinates by
/// one factor; `turn` turns about the middle of the box. A place with the coordinate of the held one comes to lie
/// exactly at that of `to`. A factor of zero is not taken: nothing, then.
std::optional<Dragged> dragged(std::span<const Vec2> places, const Box2& box, const HandleDrag& drag);

}  // namespace mes

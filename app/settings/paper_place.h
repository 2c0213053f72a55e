// SPDX-License-Identifier: GPL-3.0-or-later
// The position of a legend or a scale bar on a picture: a corner, and the distance from it.
//
// A position is valid for pictures of every size: 5 mm from the lower left corner of the window become 5 mm from the
// lower left corner of a page. Lengths are millimetres on paper, where a logical pixel is 1/96 inch; if a picture
// enlarges its lines by a factor, it enlarges the distances, too.
//
// Smallest use:
//     const PaperPlace place = place_of(corner_of_legend, size, room);   // where it was dropped
//     const Vec2 corner = placed(place, size, room_of_the_page);         // the same on a page
//
// Cost: some operations. Threads: any.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"

namespace mes {

inline constexpr double kMillimetersPerPixel = 25.4 / 96.0;  ///< size of a logical pixel
inline constexpr double kUsualMarginPx = 12.0;               ///< logical pixels
inline constexpr double kMostPlaceMm = 5080.0;               ///< no page is larger

enum class PaperCorner : std::uint8_t { top_left, top_right, bottom_left, bottom_right };

struct PaperPlace {
  PaperCorner corner = PaperCorner::bottom_right;
  /// Inwards from the corner of the picture to the same corner of the item; [0, kMostPlaceMm].
  Vec2 mm{kUsualMarginPx * kMillimetersPerPixel, kUsualMarginPx* kMillimetersPerPixel};
  friend bool operator==(const PaperPlace&, const PaperPlace&) = default;
};

/// The positions of the legend and the scale bar in the window; nothing: it is not drawn.
struct MarkPlaces {
  std::optional<PaperPlace> legend{};
  std::optional<PaperPlace> bar{};
};

/// The upper left corner of an item of this size, in logical pixels, y down. It stays in the room; an item larger
/// than the room begins where that does.
Vec2 placed(const PaperPlace& place, Vec2 size, const Box2& room);

/// The position of an item with this upper left corner, relative to the nearest corner of the room. A distance within
/// `reach` of the usual margin becomes that margin.
PaperPlace place_of(Vec2 upper_left, Vec2 size, const Box2& room, double reach = 0.0);

/// "top-left", or with millimetres "top-left:5,7.5".
std::string to_text(const PaperPlace& place);
/// The inverse of `to_text`; nothing for any other text.
std::optional<PaperPlace> parse_place(std::string_view text);

/// The names of corners, with which texts of positions begin.
std::span<const std::string_view> place_corners();

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a legend or a scale bar stands on a picture: at a corner, so far from it.
//
// A place holds for pictures of every size: what stands 5 mm from the lower left corner of the window stands 5 mm from
// the lower left corner of a page. Lengths are millimetres on paper, where a logical pixel is 1/96 inch; a picture whose
// lines are drawn larger by a factor has its places larger by the same.
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

#include "core/base/box2.h"
#include "core/base/vec2.h"

namespace mes {

inline constexpr double kMillimetersPerPixel = 25.4 / 96.0;  ///< of a logical pixel
inline constexpr double kUsualMarginPx = 12.0;               ///< logical pixels
inline constexpr double kMostPlaceMm = 5080.0;               ///< no page is larger

enum class PaperCorner : std::uint8_t { top_left, top_right, bottom_left, bottom_right };

struct PaperPlace {
  PaperCorner corner = PaperCorner::bottom_right;
  /// From the corner of the picture to the same corner of what stands there, inwards; [0, kMostPlaceMm].
  Vec2 mm{kUsualMarginPx * kMillimetersPerPixel, kUsualMarginPx* kMillimetersPerPixel};
  friend bool operator==(const PaperPlace&, const PaperPlace&) = default;
};

/// The upper left corner of something of this size, in logical pixels, y down. It stays in the room; what is larger than
/// the room begins where that does.
Vec2 placed(const PaperPlace& place, Vec2 size, const Box2& room);

/// The place of something with this upper left corner: from the corner of the room that it is nearest to. Within
/// `reach` of the usual margin it gets that.
PaperPlace place_of(Vec2 upper_left, Vec2 size, const Box2& room, double reach = 0.0);

/// "top-left", or with millimetres "top-left:5,7.5".
std::string to_text(const PaperPlace& place);
/// Nothing for any other text.
std::optional<PaperPlace> parse_place(std::string_view text);

/// What texts of places begin with.
std::span<const std::string_view> place_corners();

}  // namespace mes

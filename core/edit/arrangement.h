// SPDX-License-Identifier: GPL-3.0-or-later
// Places moved together: turned, scaled, mirrored, aligned, distributed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

/// Every function gives as many places as it is given, in their order.

/// The middle of the box around the places; (0, 0) without any.
Vec2 middle_of(std::span<const Vec2> places);

/// Turned counter-clockwise about a place. Multiples of 90 degrees turn differences exactly.
std::vector<Vec2> turned(std::span<const Vec2> places, Vec2 about, double degrees);
/// Each difference from `about` times the factor.
std::vector<Vec2> scaled(std::span<const Vec2> places, Vec2 about, double factor);

enum class Axis : std::uint8_t { x, y };
/// Reflected so that this coordinate changes its side of `about`.
std::vector<Vec2> mirrored(std::span<const Vec2> places, Vec2 about, Axis coordinate);

enum class Alignment : std::uint8_t { left, center, right, bottom, middle, top };
inline constexpr std::size_t kAlignments = 6;
/// One coordinate of all places becomes that of the box around them: x for `left`, `center`, `right`.
std::vector<Vec2> aligned(std::span<const Vec2> places, Alignment where);

/// The two that are outermost in this coordinate stay; those between come to lie at equal steps of it, in the order that
/// they have. Fewer than three stay.
std::vector<Vec2> distributed(std::span<const Vec2> places, Axis coordinate);

}  // namespace mes

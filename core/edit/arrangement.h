// SPDX-License-Identifier: GPL-3.0-or-later
// Moves points together: rotates, scales, mirrors, aligns and distributes them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Every function returns as many points as it gets, in the same order.

/// The middle of the bounding box; (0, 0) for no points.
Vec2 middle_of(std::span<const Vec2> places);

/// Rotates counter-clockwise about a point. Multiples of 90 degrees rotate differences exactly.
std::vector<Vec2> turned(std::span<const Vec2> places, Vec2 about, double degrees);
/// Multiplies each difference from `about` by the factor.
std::vector<Vec2> scaled(std::span<const Vec2> places, Vec2 about, double factor);

enum class Axis : std::uint8_t { x, y };
/// Reflects this coordinate across `about`.
std::vector<Vec2> mirrored(std::span<const Vec2> places, Vec2 about, Axis coordinate);

enum class Alignment : std::uint8_t { left, center, right, bottom, middle, top };
inline constexpr std::size_t kAlignments = 6;
/// Sets one coordinate of all points to that of their bounding box: x for `left`, `center`, `right`.
std::vector<Vec2> aligned(std::span<const Vec2> places, Alignment where);

/// The two outermost points in this coordinate stay; those between are spaced evenly, in the same order. Fewer than
/// three points stay.
std::vector<Vec2> distributed(std::span<const Vec2> places, Axis coordinate);

}  // namespace mes

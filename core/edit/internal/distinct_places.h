// SPDX-License-Identifier: GPL-3.0-or-later
// Checks shared by the line and circle functions. Private to core/edit.
#pragma once

#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// A point that occurs twice; of several, the leftmost.
std::optional<Vec2> repeated_place(std::span<const Vec2> places);
inline bool are_distinct(std::span<const Vec2> places) {
  return !repeated_place(places);
}
/// The error that names a repeated point.
std::unexpected<Error> refuse_repeated(Vec2 place);
/// The largest distance between corresponding points of two lists of equal length.
double largest_shift(std::span<const Vec2> from, std::span<const Vec2> to);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What both kinds of degenerate places are held against. Private to core/edit.
#pragma once

#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/vec2.h"

namespace mes {

/// One that is there twice; of several the first from left to right.
std::optional<Vec2> repeated_place(std::span<const Vec2> places);
inline bool are_distinct(std::span<const Vec2> places) {
  return !repeated_place(places);
}
/// Says which one.
std::unexpected<Error> refuse_repeated(Vec2 place);
/// The largest distance between places of the same position in both lists, which are equally long.
double largest_shift(std::span<const Vec2> from, std::span<const Vec2> to);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What both kinds of degenerate places are held against. Private to core/edit.
#pragma once

#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

bool are_distinct(std::span<const Vec2> places);
/// The largest distance between places of the same position in both lists, which are equally long.
double largest_shift(std::span<const Vec2> from, std::span<const Vec2> to);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Colours as files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/color.h"

namespace mes {

/// "#RRGGBB", capital letters.
std::string hexadecimal(Rgb color);
/// Parses "#RRGGBB", in either case; nothing for anything else.
std::optional<Rgb> color_from(std::string_view word);

}  // namespace mes

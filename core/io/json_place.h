// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the text of a JSON value one of its parts stands, for messages: parsers forget it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace mes {

/// A key of an object, or the position in a list.
using JsonStep = std::variant<std::string, std::size_t>;

/// Offset of the part that the steps lead to; of the last one on the way to it, if it does not exist. The text must
/// be JSON. Cost: one look at each byte before the part.
std::size_t offset_in_json(std::string_view text, std::span<const JsonStep> steps);

}  // namespace mes

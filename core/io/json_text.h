// SPDX-License-Identifier: GPL-3.0-or-later
// JSON from files nobody vouches for.
#pragma once

#include <cstddef>
#include <expected>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// An error with line and column of a byte of the text.
std::unexpected<Error> bad_json(std::string_view text, std::size_t offset, std::string what, const std::string& file);

/// Error: `bad_input` with line and column; also for objects and lists nested more than 64 deep.
Expected<nlohmann::json> parse_json(std::string_view text, const std::string& file);

}  // namespace mes

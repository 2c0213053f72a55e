// SPDX-License-Identifier: GPL-3.0-or-later
// JSON from files nobody vouches for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// Error: `bad_input` with line and column; also for objects and lists nested more than 64 deep.
Expected<nlohmann::json> parse_json(std::string_view text, const std::string& file);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of structures as text, for reading or pasting elsewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/draw/patch.h"

namespace mes {

/// Text for people: at most six significant digits, lists with commas, "-" for values that are not finite.
std::string to_text(const StatValue& value);

/// One number per line: structure, key and value, separated by tabs; `ms` and `touched` are keys too.
std::string statistics_as_tsv(std::span<const NodeReport> nodes);

/// The same as `structures` in the output of `mesecina compute`.
std::string statistics_as_json(std::span<const NodeReport> nodes);
nlohmann::ordered_json json_of(const NodeReport& node, bool with_timing);

}  // namespace mes

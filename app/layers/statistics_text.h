// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of structures as text, to be looked at or pasted elsewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/draw/patch.h"

namespace mes {

/// For people: at most six significant digits, lists with commas, "-" for what is not finite.
std::string to_text(const StatValue& value);

/// A whole number with its digits in groups of three: "12 345".
std::string grouped(std::size_t number);

/// One line a number: structure, key, value, with tabs between; `ms` and `touched` are keys too.
std::string statistics_as_tsv(std::span<const NodeReport> nodes);

/// As under `structures` of `mesecina compute`.
std::string statistics_as_json(std::span<const NodeReport> nodes);
nlohmann::ordered_json json_of(const NodeReport& node, bool with_timing);

}  // namespace mes

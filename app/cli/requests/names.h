// SPDX-License-Identifier: GPL-3.0-or-later
// Parses public names as users type them: lists of layers, number types, parameters.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/requests/requests.h"
#include "core/base/error.h"
#include "core/base/ids.h"
#include "core/document/settings/computation_settings.h"
#include "core/evolutions/evolution.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// The number of letters to insert, remove or replace to turn one word into the other. O(product of their lengths).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The most probable meanings of a mistyped word, at most three, best first: names that contain the word, or are
/// contained in it, come before others, which are ordered by edit distance.
std::vector<std::string_view> nearest_names(std::string_view word, std::span<const std::string_view> names);

/// The parts between commas, including empty ones.
std::vector<std::string_view> split_list(std::string_view text);

/// Joins names: "a", "a or b", "a, b or c".
std::string one_of(std::span<const std::string_view> names);
/// A message such as "unknown layer "curv"; did you mean curve?"
std::string unknown_word(std::string_view what, std::string_view word, std::span<const std::string_view> names);

/// Parses a comma list of layer ids, or "all"; an empty text means the layers visible at start. Returns no layer
/// twice, in the order of the list ("all" and empty: bottom first). Error: `usage` with the nearest ids.
Expected<std::vector<LayerIndex>> select_layers(const Registry& registry, const std::string& ids);
Expected<LayerIndex> select_layer(const Registry& registry, const std::string& id);

/// Parses NAME=VALUE as an index in `parameters` and a value. Error: `usage` with the option, and the nearest
/// parameters or the range. A limit beyond its range is clamped, with a remark unless `is_quiet`.
Expected<std::pair<std::size_t, double>> parse_setting(const std::string& setting,
                                                       std::span<const Parameter> parameters,
                                                       std::string_view option = "--set", bool is_quiet = false);

Expected<std::shared_ptr<const Evolution>> select_evolution(const Registry& registry, const std::string& id);
Expected<Precision> select_precision(const std::string& id);

/// Error: `usage`, "WHAT expects a whole number from LEAST to MOST, not ...".
Expected<std::uint64_t> whole_number(std::string_view what, const std::string& text, std::uint64_t least = 0,
                                     std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Number type and parameters of the command; missing ones are those of `base`. Error: `usage` with the possible
/// words. Makes remarks unless `is_quiet`.
Expected<ComputationSettings> settings_of(const Registry& registry, const Source& source,
                                          const ComputationSettings& base = {}, bool is_quiet = false);

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of the shown layers and their styles: part of bundles and sessions.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/document/settings/layer_configuration.h"
#include "core/io/session/json_view.h"

namespace mes {

/// Limit on the layers of a configuration, larger than any program needs.
inline constexpr std::size_t kMostLayers = 10'000;

nlohmann::json to_json(const LayerConfiguration& configuration);

/// The default style of a layer; any style for an unknown name.
using LayerStyleSource = std::function<LayerStyle(std::string_view layer)>;

/// Skips unknown keys; clamps numbers into their range; properties that a style omits come from `style_of`. Error:
/// `bad_input`, with the position, when something is of the wrong kind, or when names or the list of layers are
/// absurdly long.
Expected<LayerConfiguration> layer_configuration_from(
    JsonView value, const LayerStyleSource& style_of = [](std::string_view /*layer*/) { return LayerStyle{}; });

}  // namespace mes

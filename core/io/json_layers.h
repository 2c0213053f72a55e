// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown and how, as JSON: part of bundles and sessions.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/document/layer_configuration.h"
#include "core/io/json_view.h"

namespace mes {

/// More layers than any configuration names.
inline constexpr std::size_t kMostLayers = 10'000;

nlohmann::json to_json(const LayerConfiguration& configuration);

/// The style that a layer has by itself; of a name that is not known, any.
using LayerStyleSource = std::function<LayerStyle(std::string_view layer)>;

/// Keys that are not known are skipped; numbers out of range are brought into it; what a style does not say is as
/// `style_of` gives it. Error: `bad_input` when something is of the wrong kind, or names are longer or layers more
/// than anyone could mean, saying where.
Expected<LayerConfiguration> layer_configuration_from(
    JsonView value, const LayerStyleSource& style_of = [](std::string_view /*layer*/) { return LayerStyle{}; });

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown and how, as JSON: part of bundles and sessions.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/document/layer_configuration.h"

namespace mes {

nlohmann::json to_json(const LayerConfiguration& configuration);

/// Keys that are not known are skipped; numbers out of range are brought into it. Error: `bad_input` when something
/// is of the wrong kind, saying where.
Expected<LayerConfiguration> layer_configuration_from(const nlohmann::json& value);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Parses styles of layers on the command line: "medial-axis:color-map=viridis,line-width=4".
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/draw/layer_style.h"
#include "core/draw/variant.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// The styles of all layers, by layer, after the changes in `requests`, made in order. Error: `usage` with the
/// nearest words; also for a layer that is not among `drawn`. Lines are drawn `scale` times as wide later; a length
/// with a unit is one on paper, so it is divided by this factor here.
Expected<std::vector<LayerStyle>> changed_styles(const Registry& registry, std::vector<LayerStyle> styles,
                                                 std::span<const std::string> requests,
                                                 std::span<const VariantLayer> drawn,
                                                 std::span<const std::string> color_maps, double scale = 1.0);

/// The keys of a request, for the help page.
std::string style_keys();

}  // namespace mes::cli

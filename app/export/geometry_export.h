// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the geometry of layers from scratch, and writes it as text for other programs.
#pragma once

#include <filesystem>
#include <vector>

#include "app/export/computation.h"
#include "app/store/texts/layer_text.h"

namespace mes {

/// The layers to compute for a text of these layers: themselves, and others that the format needs.
std::vector<LayerIndex> layers_for(const Registry& registry, const LayerTextFormat& format,
                                   std::vector<LayerIndex> layers);

/// Computes the layers and writes them. `request.layers` are the layers to write; its `on_patch` is not used. Errors
/// of `check_layers` and `run_computation`. Threads: any.
Expected<LayerText> compute_layer_text(const Registry& registry, const SampleData& data,
                                       const LayerTextFormat& format, ComputationRequest request);

/// The parts that the text lacks, in one sentence; empty if it lacks nothing.
std::string remark_about(const LayerText& text, const LayerTextFormat& format);

}  // namespace mes

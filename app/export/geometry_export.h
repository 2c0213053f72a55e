// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of layers, computed afresh, as text that other programs read.
#pragma once

#include <filesystem>
#include <vector>

#include "app/export/computation.h"
#include "app/store/layer_text.h"

namespace mes {

/// What is computed for a text of these layers: they, and what else the format needs.
std::vector<LayerIndex> layers_for(const Registry& registry, const LayerTextFormat& format,
                                   std::vector<LayerIndex> layers);

/// Computes the layers and writes them. `request.layers` are those to be written; its `on_patch` is not used. Errors of
/// `check_layers` and `run_computation`. Any thread.
Expected<LayerText> compute_layer_text(const Registry& registry, const SampleData& data,
                                       const LayerTextFormat& format, ComputationRequest request);

/// What the text lacks, one sentence; empty where it lacks nothing.
std::string remark_about(const LayerText& text, const LayerTextFormat& format);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// A computation of samples or balls alone, beside the engine's.
#pragma once

#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/vec2.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"

namespace mes {

/// Brings what the layer needs up to date for this document, or for samples at these positions alone, in a graph that has not run. Throws `Cancelled`.
/// Error: these cannot be a document, or a structure failed. Cost: of the layer's structures from scratch.
Expected<void> compute_alone(Graph& graph, const SampleData& data, std::string_view layer, JobControl& job);
Expected<void> compute_samples_alone(Graph& graph, std::span<const Vec2> positions, std::string_view layer,
                                     JobControl& job);

}  // namespace mes

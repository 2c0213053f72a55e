// SPDX-License-Identifier: GPL-3.0-or-later
// Samples in, finished layers out: the engine run to its end.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/document/document.h"
#include "core/draw/patch.h"

namespace mes::cli {

struct ComputationRequest {
  std::vector<LayerIndex> layers;
  ComputationSettings settings;
  bool want_statistics = false;
  bool want_findings = false;
  /// Gets every patch in order; the last one's reports are final.
  std::function<void(const FramePatch&)> on_patch;
};

struct ComputationResult {
  Document document;
  std::vector<NodeReport> nodes;     ///< of the structures that were needed
  std::vector<LayerReport> reports;  ///< by layer
};

/// Shows progress on a terminal. Error: `cannot_compute` with the reason when a structure failed, `usage` when the
/// samples do not make a document.
Expected<ComputationResult> run_computation(const SampleData& data, const ComputationRequest& request);

}  // namespace mes::cli

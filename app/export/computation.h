// SPDX-License-Identifier: GPL-3.0-or-later
// Samples in, finished layers out: a workbench that is run to its end, with progress.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/workbench/workbench.h"

namespace mes {

struct ComputationRequest {
  std::vector<VariantLayer> layers;
  ComputationSettings settings;
  bool want_statistics = false;
  bool want_findings = false;
  /// Of a one-shot run: otherwise scalars of instances are not looked for, and may be 0.
  bool needs_scalars = true;
  /// Gets the patch of the run.
  std::function<void(const FramePatch&)> on_patch;
  /// What is being computed, and how much of the whole is done, in [0, 1]; some ten times a second. May be empty.
  std::function<void(std::string_view task, double fraction)> on_progress{};
  std::vector<WorkbenchVariant> variants{};
  /// Ends it early, with the error `cancelled`.
  std::stop_token stop{};
};

/// What a run says when its layers are not kept.
struct ComputationReport {
  std::vector<NodeReport> nodes;     ///< of the structures that were needed
  std::vector<LayerReport> reports;  ///< by layer
};

struct ComputationResult {
  Document document;
  std::vector<Document> documents;   ///< of the variants; empty ones where they share that of the main computation
  std::vector<NodeReport> nodes;     ///< of the structures that were needed
  std::vector<LayerReport> reports;  ///< by layer
};

/// Error: `cannot_compute` with the reason when a structure failed, `usage` when the samples do not make a document.
/// The functions of the request are called on the calling thread, any one.
Expected<ComputationResult> run_computation(const Registry& registry, const SampleData& data,
                                            const ComputationRequest& request);

/// As `run_computation`, in a one-shot graph (core/engine/graph.h): layers are handed to `take` in pieces, and the data
/// are given up as soon as they have been read. `take` is called on threads of the graph: for one layer by one of them,
/// for several perhaps at once; it must not throw. The request has no variants and no `on_patch`. An error makes what
/// was taken worthless.
Expected<ComputationReport> run_one_shot(const Registry& registry, SampleData data, const ComputationRequest& request,
                                         std::function<void(const InstancePiece&)> take);

}  // namespace mes

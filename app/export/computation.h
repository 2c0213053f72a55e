// SPDX-License-Identifier: GPL-3.0-or-later
// Computes finished layers from samples: runs a workbench to its end and reports progress.
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
  /// Structures that are computed even if no layer reads them.
  std::vector<std::string_view> structures{};
  ComputationSettings settings;
  bool want_statistics = false;
  bool want_findings = false;
  /// For a one-shot run: if false, scalars of instances are not computed and may be 0.
  bool needs_scalars = true;
  /// Receives the patch of the run.
  std::function<void(const FramePatch&)> on_patch;
  /// Receives the present task and the finished share of the whole, in [0, 1], some ten times a second. May be empty.
  std::function<void(std::string_view task, double fraction)> on_progress{};
  std::vector<WorkbenchVariant> variants{};
  /// Ends the computation early, with the error `cancelled`.
  std::stop_token stop{};
};

/// The report on a run whose layers are not kept.
struct ComputationReport {
  std::vector<NodeReport> nodes;     ///< reports of the structures that were needed
  std::vector<LayerReport> reports;  ///< one per layer
};

struct ComputationResult {
  Document document;
  std::vector<Document> documents;   ///< one per variant; empty if it shares that of the main computation
  std::vector<NodeReport> nodes;     ///< reports of the structures that were needed
  std::vector<LayerReport> reports;  ///< one per layer
};

/// Error: `cannot_compute` with the reason if a structure failed, `usage` if the samples make no document. The
/// functions of the request are called on the calling thread. Threads: any.
Expected<ComputationResult> run_computation(const Registry& registry, const SampleData& data,
                                            const ComputationRequest& request);

/// As `run_computation`, in a one-shot graph (core/engine/graph.h): layers are passed to `take` in pieces, and the
/// data are released as soon as they have been read. `take` is called on threads of the graph, for one layer from one
/// of them, for several perhaps at once; it must not throw. The request must have no variants and no `on_patch`.
/// After an error the pieces already taken are worthless.
Expected<ComputationReport> run_one_shot(const Registry& registry, SampleData data, const ComputationRequest& request,
                                         std::function<void(const InstancePiece&)> take);

}  // namespace mes

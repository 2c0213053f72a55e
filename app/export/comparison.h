// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of several panes side by side, each of which shows the same thing in another way: with another number
// type, another parameter, other layers, other samples.
//
// All panes are computed at once, as variants (core/draw/variant.h), so that shared results exist once. All show the
// same part of the plane at the same scale.
//
// Smallest use:
//     Comparison comparison = compare(registry, std::move(requests));
//     run_computation(registry, *comparison.data, {.layers = comparison.demand, ..., .variants = comparison.variants});
//     share_color_ranges(comparison, mirror);
//     const auto drawn = draw_pane_figure(request, comparison, sources);
//
// Cost: that of the computations; differences O(instances). Threads: any, with a comparison of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/export/computation.h"
#include "app/export/shown_layers.h"
#include "app/layers/layer_stack.h"
#include "app/panes/pane_list.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/patch.h"
#include "core/draw/variant.h"
#include "render/scene.h"

namespace mes {

inline constexpr std::size_t kMostPanes = 16;

struct PaneRequest {
  std::string words;  ///< its difference, such as "precision exact"
  ShownLayers shown;  ///< layers by their indices in the main computation
  ComputationSettings settings;
  std::shared_ptr<const SampleData> data;
};

/// The panes of the window.
struct PanesOfWindow {
  const ShownPanes& shown;
  const LayerStack& layers;
  const ComputationSettings& settings;
  std::vector<std::string> words;  ///< descriptions of all panes, the main one first
};
/// All panes, the main one for these data first. `own_data` returns the data of a pane that shows its own version,
/// and null for other panes.
std::vector<PaneRequest> pane_requests(
    const PanesOfWindow& panes, const std::shared_ptr<const SampleData>& data,
    const std::function<std::shared_ptr<const SampleData>(std::size_t pane)>& own_data);

struct Pane {
  std::string label;   ///< "(a) precision exact"
  std::string letter;  ///< "a"
  ShownLayers shown;
  VariantIndex variant = kMainVariant;
  std::shared_ptr<const SampleData> data;
  std::vector<render::LayerView> marks{};  ///< elements that only some of the panes have
};

struct Comparison {
  std::vector<Pane> panes;
  /// Data of the main computation, which is that of the first pane.
  std::shared_ptr<const SampleData> data;
  ComputationSettings settings;
  std::vector<WorkbenchVariant> variants;
  std::vector<VariantLayer> demand;
  /// The document of a pane.
  const Document& document_of(const Pane& pane, const ComputationResult& result) const {
    const bool is_shared = pane.variant == kMainVariant || !variants[pane.variant - 1].data;
    return is_shared ? result.document : result.documents[pane.variant - 1];
  }
};

/// Panes with the same settings and the same data (by address) share a variant. There must be one to `kMostPanes`
/// panes. Their layers are those of the registry.
Comparison compare(const Registry& registry, std::vector<PaneRequest> panes);

/// The panes of the window, main pane first, for comparing their drawings. They have no data.
Comparison comparison_of(const ShownPanes& shown, const LayerStack& layers);

/// Gives a layer that follows a colour map the same range in all panes, unless its range is chosen.
void share_color_ranges(Comparison& comparison, const LayerMirror& mirror);

/// Finds what some pane draws in a layer and another pane with the layer does not. The differences are layers of
/// their own, added to the marks of the panes; `extent` is that of the whole drawing. The patch is for the scene and
/// the mirror.
FramePatch mark_differences(Comparison& comparison, const LayerMirror& mirror, double extent);

}  // namespace mes

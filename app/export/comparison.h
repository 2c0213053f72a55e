// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of several panes side by side, each of which shows the same thing otherwise: with another number type,
// another parameter, other layers, other samples.
//
// All panes are computed at once, as variants (core/draw/variant.h), so that what they share is there once, and all show
// the same part of the plane at the same scale.
//
// Smallest use:
//     Comparison comparison = compare(std::move(requests));
//     run_computation(*comparison.data, {.layers = comparison.demand, ..., .variants = comparison.variants});
//     share_color_ranges(comparison, mirror);
//     const PaneGrid grid = lay_out(comparison.panes.size(), 1600.0, 1200.0, aspect, 1.0);
//
// Cost: that of the computations; differences O(instances). Threads: any, with a comparison of its own.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/export/computation.h"
#include "app/export/shown_layers.h"
#include "app/picture/paper_drawing.h"
#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/patch.h"
#include "core/draw/variant.h"
#include "render/scene.h"

namespace mes {

inline constexpr std::size_t kMostPanes = 16;

struct PaneRequest {
  std::string words;  ///< what is different in it, as "precision exact"
  ShownLayers shown;  ///< layers by their numbers in the main computation
  ComputationSettings settings;
  std::shared_ptr<const SampleData> data;
};

struct Pane {
  std::string label;   ///< "(a) precision exact"
  std::string letter;  ///< "a"
  ShownLayers shown;   ///< layers by their numbers in all variants
  VariantIndex variant = kMainVariant;
  std::shared_ptr<const SampleData> data;
  std::vector<render::LayerView> marks{};  ///< what only some of the panes have
};

struct Comparison {
  std::vector<Pane> panes;
  /// Of the main computation, that of the first pane.
  std::shared_ptr<const SampleData> data;
  ComputationSettings settings;
  std::vector<ComputedVariant> variants;
  std::vector<LayerIndex> demand;
  /// The document of a pane.
  const Document& document_of(const Pane& pane, const ComputationResult& result) const {
    const bool is_shared = pane.variant == kMainVariant || !variants[pane.variant - 1].data;
    return is_shared ? result.document : result.documents[pane.variant - 1];
  }
};

/// Panes with the same settings and the same data (by address) are of one variant. One pane at least, `kMostPanes` at
/// most.
Comparison compare(std::vector<PaneRequest> panes);

/// Gives a layer that follows a colour map the same range in all panes, unless its range is chosen.
void share_color_ranges(Comparison& comparison, const LayerMirror& mirror);

/// What some pane draws in a layer and another pane that shows the layer does not, as layers of their own, which are
/// added to the marks of the panes; `extent` is of all that is drawn. The patch is for the scene and the mirror.
FramePatch mark_differences(Comparison& comparison, const LayerMirror& mirror, double extent);

/// Where panes lie on a page; all have the same size. Lengths as those of the page.
struct PaneGrid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  double pane_width = 0.0;
  double pane_height = 0.0;
  double gap = 0.0;   ///< between neighbours
  double band = 0.0;  ///< below each pane, for its label
  /// The upper left corner of a pane.
  Vec2 corner(std::size_t pane) const;
};

/// The columns with which a box of the given proportions (height by width) is drawn largest; `unit` is the length of a
/// logical pixel. Sides of panes may come out too small, or negative.
PaneGrid lay_out(std::size_t panes, double width, double height, double proportions, double unit);

/// Width of the line around a pane, in logical pixels.
inline constexpr double kPaneFrame = 0.75;

/// The labels below the panes, and a line around each, on a page in logical pixels.
PaperDrawing layout_pane_labels(const Comparison& comparison, const PaneGrid& grid, const MeasureText& measure,
                                const std::optional<Rgb>& background);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The legend. A layer with a colour map has its name, the meaning of the scalar, and a bar of colours with numbers;
// in a key, every other layer has a sample of its look, and its name.
//
// Smallest use:
//     const std::vector<LegendEntry> entries = legend_of(layers, scene, views);
//     const PlacedLegend legend = place_legend(entries, fonts, 1.0, {.room = room}, kWhiteCanvas);  // legend_place.h
//
// Cost: some hundred rectangles per layer. Threads: any, with a picture of its own.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/layers/legend_scope.h"
#include "app/picture/paper/paper_drawing.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/layer_style.h"
#include "core/draw/primitives.h"
#include "render/figure/figure_of.h"
#include "render/instances/colormap.h"
#include "render/scene.h"

namespace mes {

/// Width of a legend with a bar of colours, in its logical pixels.
inline constexpr double kLegendWidth = 240.0;

/// A number beside a bar.
struct LegendTick {
  double at = 0.0;  ///< along the bar, in [0, 1]
  std::string label;
  friend bool operator==(const LegendTick&, const LegendTick&) = default;
};

/// The look of a layer.
struct LayerSample {
  PrimitiveKind kind = PrimitiveKind::segment;
  LayerStyle style{};
  bool is_text = false;
  friend bool operator==(const LayerSample&, const LayerSample&) = default;
};

struct LegendEntry {
  std::string title;
  std::string scalar;
  const render::ColorMap* map = nullptr;  ///< null: one colour, that of the sample
  render::ScalarRange range;
  LayerSample sample{};
  friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// The entries of layers, topmost first; `views` begin at the bottom, and `descriptors` are those of all layers. The
/// maps are those of the scene.
std::vector<LegendEntry> legend_of(std::span<const LayerDescriptor> descriptors, const render::Scene& scene,
                                   std::span<const render::LayerView> views,
                                   LegendScope scope = LegendScope::color_maps);
/// The same for a figure, whose maps are those of the drawing.
std::vector<LegendEntry> legend_of(const figure::Drawing& drawing, LegendScope scope);

/// The ends of a range and a few round numbers between, with as few digits as distinguish them. A range of one value
/// has one tick, an empty one none.
std::vector<LegendTick> legend_ticks(const render::ScalarRange& range);

/// Places the entries below each other, with light text on a dark background. A last line counts the entries that do
/// not fit into the height `room`. Without entries the legend is empty.
PaperDrawing layout_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double room,
                           const std::optional<Rgb>& background);

/// Places all entries in as few rows as the width permits, column by column.
PaperDrawing layout_wide_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double width,
                                const std::optional<Rgb>& background);

}  // namespace mes

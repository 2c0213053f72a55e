// SPDX-License-Identifier: GPL-3.0-or-later
// The legend: of layers with a colour map the name, the meaning of the scalar, and a bar of colours with numbers; in a
// key, of all other layers a sample of how they are drawn, and the name.
//
// Smallest use:
//     const std::vector<LegendEntry> entries = ...;
//     draw_legend(image, fonts, layout_legend(entries, fonts, image.width, image.height, 1.0, kWhiteCanvas),
//                 LegendPlace::emptiest_corner);
//
// Cost: some hundred rectangles a layer. Threads: any, with a picture of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/layers/legend_scope.h"
#include "app/model/paper_place.h"
#include "app/picture/paper_drawing.h"
#include "core/draw/layer_style.h"
#include "core/draw/primitives.h"
#include "render/colormap.h"
#include "render/scene.h"

namespace mes {

/// A number beside a bar.
struct LegendTick {
  double at = 0.0;  ///< along the bar, in [0, 1]
  std::string label;
  friend bool operator==(const LegendTick&, const LegendTick&) = default;
};

/// How a layer is drawn.
struct LayerSample {
  PrimitiveKind kind = PrimitiveKind::segment;
  LayerStyle style{};
  bool is_text = false;
  friend bool operator==(const LayerSample&, const LayerSample&) = default;
};

struct LegendEntry {
  std::string title;
  std::string scalar;
  const render::ColorMap* map = nullptr;  ///< null: one colour, as in the sample
  render::ScalarRange range;
  LayerSample sample{};
  friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// The entries of layers, topmost first; `views` are bottom first. The maps are those of the scene.
std::vector<LegendEntry> legend_of(const render::Scene& scene, std::span<const render::LayerView> views,
                                   LegendScope scope = LegendScope::color_maps);

/// The ends of a range and a few round numbers between, with as few digits as distinguish them. A range of one value
/// has one tick, an empty one none.
std::vector<LegendTick> legend_ticks(const render::ScalarRange& range);

/// Places the entries one below the other, with light text on a dark background. A last line counts the entries that do
/// not fit into the height `room`. Without entries the legend is empty.
PaperDrawing layout_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double room,
                           const std::optional<Rgb>& background);

/// A legend for a picture of some size; scales are in pixels per logical pixel.
struct PictureLegend {
  PaperDrawing drawing;
  double scale = 1.0;        ///< of the legend
  double paper_scale = 1.0;  ///< of everything else that stands on the picture
};
/// Reduces the scale of the legend somewhat for a small picture.
PictureLegend layout_legend(std::span<const LegendEntry> entries, const PaperFonts& fonts, int width, int height,
                            double scale, const std::optional<Rgb>& background);

/// The corner of a legend: the one where it hides least, the lower right one if all are alike; or always the lower
/// right one, for sequences of pictures, `foot` pixels above the bottom. `room`: where the corners are of the emptiest
/// one, in pixels; empty: of the picture.
enum class LegendPlace : std::uint8_t { emptiest_corner, lower_right };
void draw_legend(render::Image& image, const PaperFonts& fonts, const PictureLegend& legend, LegendPlace place,
                 double foot = 0.0, const Box2& room = {});

/// The upper left corner of a legend that has a place. `room` is the picture without what lies over its ends, in pixels.
Vec2 corner_of(const PictureLegend& legend, const PaperPlace& place, const Box2& room);
/// There.
void draw_legend(render::Image& image, const PaperFonts& fonts, const PictureLegend& legend, const PaperPlace& place,
                 const Box2& room);

}  // namespace mes

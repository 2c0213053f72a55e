// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of the colour maps in use: for each layer its name, what its scalar is, and a bar of colours with
// numbers.
//
// It is laid out once, as rectangles and lines of text, and then painted by whoever has something to paint on: the
// window, or a picture in memory. So both look alike.
//
// Smallest use:
//     const std::vector<LegendEntry> entries = ...;
//     draw_legend(image, fonts, layout_legend(entries, fonts, image.width, image.height, 1.0, kWhiteCanvas),
//                 LegendPlace::emptiest_corner);
//
// Cost: some hundred rectangles a layer. Threads: none.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/draw/layer_descriptor.h"
#include "render/colormap.h"
#include "render/scene.h"
#include "render/text.h"

namespace mes {

/// A number beside a bar.
struct LegendTick {
  double at = 0.0;  ///< along the bar, in [0, 1]
  std::string label;
  friend bool operator==(const LegendTick&, const LegendTick&) = default;
};

struct LegendEntry {
  std::string title;
  std::string scalar;
  const render::ColorMap* map = nullptr;
  render::ScalarRange range;
  friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// Of the layers with a map that has something to colour, topmost first; `views` are bottom first. Their maps live as
/// long as the scene.
std::vector<LegendEntry> legend_of(const render::Scene& scene, std::span<const render::LayerView> views);

/// The ends of a range and a few round numbers between, the shortest way that tells them apart. Of a range of one
/// value that value, of an empty one nothing.
std::vector<LegendTick> legend_ticks(const render::ScalarRange& range);

/// Lengths are logical pixels from the upper left corner of the legend.
struct LegendDrawing {
  struct Box {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    Rgb color;
    double opacity = 1.0;
  };
  struct Line {
    double x = 0.0;
    double top = 0.0;
    double size = 0.0;
    bool is_bold = false;
    Rgb color;
    std::string text;
  };
  double width = 0.0;
  double height = 0.0;
  std::vector<Box> boxes;
  std::vector<Line> lines;  ///< above the boxes
};

/// Width of a text in logical pixels, at a size in logical pixels.
using MeasureText = std::function<double(const std::string& text, double size, bool is_bold)>;

/// Light writing on a dark background. One below the other; those that do not fit into `room` are counted in a last
/// line. Nothing without entries.
LegendDrawing layout_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double room,
                            const std::optional<Rgb>& background);

struct LegendFonts {
  render::Font plain;
  render::Font bold;
  /// Those that come with the program.
  static Expected<LegendFonts> read(const std::filesystem::path& assets);
};

/// A legend laid out for a picture of some size; `scale` pixels to a logical one.
struct PictureLegend {
  LegendDrawing drawing;
  double scale = 1.0;
};
/// `scale` is taken somewhat smaller on a small picture.
PictureLegend layout_legend(std::span<const LegendEntry> entries, const LegendFonts& fonts, int width, int height,
                            double scale, const std::optional<Rgb>& background);

/// Where a legend goes: the corner where it hides least (the lower right one if all are alike), or always the same,
/// for pictures that follow one another. `foot` pixels at the bottom are left free there.
enum class LegendPlace : std::uint8_t { emptiest_corner, lower_right };
void draw_legend(render::Image& image, const LegendFonts& fonts, const PictureLegend& legend, LegendPlace place,
                 double foot = 0.0);

}  // namespace mes

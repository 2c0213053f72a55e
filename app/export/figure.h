// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of layers for a page: what `mesecina render` writes into a vector format, and the window exports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/export/page_size.h"
#include "app/export/shown_layers.h"
#include "app/layers/legend_scope.h"
#include "app/model/scale_marks.h"
#include "app/picture/annotation_drawing.h"
#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/document/layer_configuration.h"
#include "core/draw/layer_mirror.h"
#include "render/colormap.h"
#include "render/figure/figure_of.h"
#include "render/image.h"

namespace mes {

/// What "fit" shows.
struct Everything {};

/// The part of the plane that is shown: what "fit" shows, a box, or a page at its natural size.
using ShownPart = std::variant<Everything, Box2, figure::Page>;

struct FigureRequest {
  ShownLayers shown;
  ShownPart part;
  /// None: the size of `part` if that is a page, or else `pixels`. A height that `part` does not fill shows more.
  std::optional<PageSize> page{};
  int pixels[2] = {1600, 1200};  ///< width and height, of 1/96 inch
  bool is_tight = false;         ///< the page is cut to what is drawn
  LegendScope legend = LegendScope::color_maps;
  std::optional<PaperPlace> legend_at{};  ///< none: where it hides least
  ScaleMarks marks{};
  std::string title{};  ///< as `rich_text` has it, in a band above the drawing; empty: none
  bool with_annotations = true;
  std::vector<render::LayerView> marks_above{};  ///< what other panes lack, above the layers; in no legend
  BackgroundImage image{};                       ///< the place of the picture to trace
  std::vector<std::string> rasterized{};         ///< ids of layers that become pictures
  double dots_per_inch = 300.0;                  ///< of these
};

/// What a figure is made of.
struct FigureSource {
  const LayerMirror& mirror;
  const Box2& bounds;  ///< of the document
  std::span<const render::ColorMap> maps;
  const render::Image* traced = nullptr;  ///< null: none
  PlacedAnnotations annotations{};
  const Document& document;  ///< that layers of texts tell of, and whose samples stand close or not
};

/// Files of figures above this are worth a warning: mail refuses them, viewers are slow.
inline constexpr std::size_t kLargeFigure = 20'000'000;
/// TikZ figures of more shapes are worth a warning: 100,000 translucent disks took pdflatex 73 s, and no more memory than
/// a few thousand (render/figure/tikz.cpp).
inline constexpr std::size_t kMostTexShapes = 100'000;
/// The warning, one sentence; empty: none is due.
std::string tex_warning(std::size_t shapes, std::string_view extension);

/// The layer with the most shapes; null when none has any.
const figure::FigureLayer* largest_layer(const figure::Figure& figure);

/// All of the natural page on one of another size, in its middle.
figure::Page resized(const figure::Page& natural, const PageSize& size);

struct DrawnFigure {
  figure::Figure figure;
  std::vector<std::string> remarks;  ///< what was left out, one sentence each
};

/// Error: `usage` for pictures in it that would be too large, `out_of_memory`. O(n log n) for n primitives. Any thread.
Expected<DrawnFigure> draw_figure(const FigureRequest& request, const FigureSource& source);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of layers on a page, as `mesecina render` writes it in vector formats and the window exports it.
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
#include "app/picture/annotations/annotation_drawing.h"
#include "app/settings/scale_marks.h"
#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/document/settings/layer_configuration.h"
#include "core/draw/layer_mirror.h"
#include "render/figure/figure_of.h"
#include "render/image/image.h"
#include "render/instances/colormap.h"

namespace mes {

/// Stands for the area that "fit" shows.
struct Everything {};

/// The visible part of the plane: that of "fit", a box, or a page at its natural size.
using ShownPart = std::variant<Everything, Box2, figure::Page>;

struct FigureRequest {
  ShownLayers shown;
  ShownPart part;
  /// Nothing: the size of `part` if that is a page, or else `pixels`. A height that `part` does not fill shows more.
  std::optional<PageSize> page{};
  int pixels[2] = {1600, 1200};  ///< width and height in pixels of 1/96 inch
  bool is_tight = false;         ///< the page is cut to the drawing
  bool keeps_letters = false;    ///< the letters of the legend are as large as others, on a small page as well
  LegendScope legend = LegendScope::color_maps;
  std::optional<PaperPlace> legend_at{};  ///< nothing: where it hides least
  bool legend_beside = false;  ///< a legend that would hide the drawing in each corner has a strip beside it
  ScaleMarks marks{};
  std::string title{};  ///< in the syntax of `rich_text`, in a band above the drawing; empty: no title
  bool with_annotations = true;
  std::vector<render::LayerView> marks_above{};  ///< elements that other panes lack, above the layers; in no legend
  BackgroundImage image{};                       ///< position of the picture to trace
  std::vector<std::string> rasterized{};         ///< ids of layers that become pictures
  double dots_per_inch = 300.0;                  ///< for these
};

/// The sources of a figure.
struct FigureSource {
  const LayerMirror& mirror;
  const Box2& bounds;  ///< bounds of the document
  std::span<const render::ColorMap> maps;
  const render::Image* traced = nullptr;  ///< null: no picture
  PlacedAnnotations annotations{};
  const Document& document;  ///< for layers of texts, and for the spacing of its samples
};

/// Larger files of figures deserve a warning: mail refuses them, and viewers are slow.
inline constexpr std::size_t kLargeFigure = 20'000'000;
/// TikZ figures with more shapes deserve a warning: 100,000 translucent disks took pdflatex 73 s, but no more memory
/// than a few thousand (render/figure/tikz.cpp).
inline constexpr std::size_t kMostTexShapes = 100'000;
/// The warning in one sentence; empty if none is needed.
std::string tex_warning(std::size_t shapes, std::string_view extension);

/// The layer with the most shapes; null if no layer has any.
const figure::FigureLayer* largest_layer(const figure::Figure& figure);

/// Puts all of the natural page in the middle of a page of another size.
figure::Page resized(const figure::Page& natural, const PageSize& size);

struct DrawnFigure {
  figure::Figure figure;
  std::vector<std::string> remarks;  ///< parts that were left out, one sentence each
};

/// Error: `usage` if pictures in it would be too large, `out_of_memory`. O(n log n) for n primitives. Threads: any.
Expected<DrawnFigure> draw_figure(const FigureRequest& request, const FigureSource& source);

}  // namespace mes

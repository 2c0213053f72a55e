// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/figure.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/editing/curves/sample_spacing.h"
#include "app/export/explanations.h"
#include "app/picture/paper/lacking_letters.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/picture/paper/title_drawing.h"
#include "app/picture/sample_texts.h"
#include "app/store/sample_shapes.h"
#include "core/draw/variant.h"
#include "render/camera.h"
#include "render/figure/raster.h"

namespace mes {

figure::Page resized(const figure::Page& natural, const PageSize& size) {
  figure::Page page = natural;
  page.width = size.width;
  page.height = size.height.value_or(natural.height * size.width / natural.width);
  page.units_per_point *= std::max(natural.width / page.width, natural.height / page.height);
  return page;
}

namespace {

/// A box that fills the page, or all but a margin of it.
struct FittedBox {
  Box2 box;
  double margin = 0.0;  // share of the shorter side
};

FittedBox fitted_box(const FigureRequest& request, const FigureSource& source) {
  if (const Box2* const box = std::get_if<Box2>(&request.part)) return {*box, 0.0};
  return {fit_box(request.shown.descriptors, source.bounds, source.mirror, request.shown.layers), kFitMargin};
}

/// The height of a page that its content fills, margins included.
double natural_height(const FittedBox& shown, double width) {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 3.0;
  const double ratio = shown.box.is_empty() || !(shown.box.width() > 0.0)
                           ? 1.0
                           : std::clamp(shown.box.height() / shown.box.width(), kLeast, kMost);
  const double both = 2.0 * shown.margin;
  // The margin is a share of the shorter side, which is the height if the ratio is below 1.
  return ratio < 1.0 ? ratio * width / (1.0 - both + both * ratio) : (1.0 - both) * width * ratio + both * width;
}

/// The request for the part within strips at the edges. If the height of the page follows from its content, the
/// content keeps its full height.
FigureRequest within(FigureRequest request, const PageEdges& edges) {
  const double both = edges.above + edges.below;
  if (request.page) request.page->width -= edges.right;
  if (request.page && request.page->height) *request.page->height -= both;
  if (request.page || std::holds_alternative<figure::Page>(request.part)) return request;
  request.pixels[0] -= static_cast<int>(std::lround(edges.right / figure::kPointsPerPixel));
  request.pixels[1] -= static_cast<int>(std::lround(both / figure::kPointsPerPixel));
  return request;
}

figure::Page page_for(const FigureRequest& request, const FigureSource& source) {
  if (const figure::Page* const natural = std::get_if<figure::Page>(&request.part))
    return request.page ? resized(*natural, *request.page) : *natural;
  const FittedBox shown = fitted_box(request, source);
  // `scale` is in pixels of the camera per logical pixel.
  const auto edges = [&](double scale) {
    return request.marks.axes && shown.margin > 0.0 && !request.is_tight ? room_of_axes(scale) : EdgeRoom();
  };
  if (!request.page)
    return figure::page_of(
        camera_within(edges(request.shown.scale), request.pixels[0], request.pixels[1], shown.box, shown.margin));
  // A camera has whole pixels: enough of them that the rounding of the page's sides is invisible.
  constexpr double kPixelsPerPoint = 64.0;
  const double width = request.page->width;
  const EdgeRoom axes = edges(kPixelsPerPoint * figure::kPointsPerPixel * request.shown.scale);
  const double height = request.page->height.value_or(
      natural_height(shown, std::max(1.0, width - axes.left / kPixelsPerPoint)) + axes.below / kPixelsPerPoint);
  const auto pixels = [](double points) { return static_cast<int>(std::lround(kPixelsPerPoint * points)); };
  figure::Page page =
      figure::page_of(camera_within(axes, pixels(width), pixels(height), shown.box, shown.margin), width);
  page.height = height;
  return page;
}

/// The title on a page of this size, which has no band yet.
PictureTitle title_on(const figure::Page& page, const FigureRequest& request, const PaperFonts& fonts) {
  const double points = request.shown.scale * figure::kPointsPerPixel;
  return layout_title(request.title, page.width / points, page.height / points,
                      measure_with(fonts, request.shown.scale), request.shown.background);
}

/// Rounded up to whole pixels of 1/96 inch, in points.
double whole_pixels(double points) {
  return figure::kPointsPerPixel * std::ceil(points / figure::kPointsPerPixel);
}

/// A page with room for its title.
struct TitledPage {
  figure::Page page;
  PictureTitle title;
};

bool has_texts(const ShownLayers& shown) {
  return std::ranges::any_of(
      shown.layers, [&](VariantLayer layer) { return shown.descriptors[layer.layer].points_as != PointsAs::dots; });
}

/// The part of the plane on the page.
Box2 plane_on(const figure::Page& page) {
  const Vec2 half = 0.5 * page.units_per_point * Vec2{page.width, page.height};
  const Vec2 center = page.center + page.center_low;
  return {center - half, center + half};
}

/// Adds layers of their own above all others: highlights first, then the rest.
void add_annotations(figure::Figure& figure, const AnnotationDrawing& drawn, double scale, const PaperFonts& fonts) {
  const double points = scale * figure::kPointsPerPixel;
  if (!drawn.highlights.is_empty())
    add_layer(figure, fonts, drawn.highlights, {0.0, 0.0}, scale,
              {.id = "highlights", .title = "Highlights", .line_width = kHighlightLine * points});
  if (!drawn.drawing.is_empty())
    add_layer(figure, fonts, drawn.drawing, {0.0, 0.0}, scale,
              {.id = "annotations", .title = "Annotations", .line_width = kAnnotationLine * points});
}

}  // namespace

const figure::FigureLayer* largest_layer(const figure::Figure& figure) {
  const auto largest = std::ranges::max_element(
      figure.layers, {}, [](const figure::FigureLayer& layer) { return figure::shape_count(layer); });
  return largest != figure.layers.end() && figure::shape_count(*largest) != 0 ? &*largest : nullptr;
}

Expected<DrawnFigure> draw_figure(const FigureRequest& request, const FigureSource& source) {
  const double scale = request.shown.scale;
  const double points = scale * figure::kPointsPerPixel;
  const std::vector<render::LayerView> views = views_of(request.shown, 0.0);
  const figure::Drawing explained{.mirror = source.mirror,
                                  .layers = request.shown.descriptors,
                                  .views = views,
                                  .maps = source.maps,
                                  .background = request.shown.background,
                                  .scale = scale,
                                  .traced = {find_layer(request.shown.descriptors, "image"),
                                             source.traced,
                                             {request.image.center, request.image.width}}};
  const bool is_annotated = request.with_annotations && !source.annotations.is_empty();
  std::vector<LegendEntry> entries = legend_of(explained, request.legend);
  const bool is_numbered = has_texts(request.shown);
  std::optional<PaperFonts> fonts;
  DrawnFigure out;
  if (is_annotated || !entries.empty() || is_numbered || !request.title.empty() || !request.marks.is_empty()) {
    if (auto read = PaperFonts::read(find_assets({})))
      fonts = std::move(*read);
    else
      out.remarks.push_back("title, annotations, numbers, legend, scale bar and axes are left out: " +
                            read.error().message());
  }
  const double spacing = typical_spacing(source.document);
  const auto drawn_on = [&](const figure::Page& page, const AnnotationDrawing& annotated) {
    const double units_per_px = page.units_per_point * points;
    std::vector<render::LayerView> all = views_of(request.shown, spacing / units_per_px);
    all.insert(all.end(), request.marks_above.begin(), request.marks_above.end());
    add_texts(request.shown.descriptors, all, {source.document}, {plane_on(page), units_per_px},
              fonts ? &fonts->plain : nullptr);
    figure::Drawing drawing = explained;
    drawing.views = all;
    figure::Figure figure = figure::figure_of(drawing, page);
    for (figure::FigureLayer& mark : std::span(figure.layers).subspan(views.size())) {
      mark.id += "-only-here";
      mark.title += ", only here";
    }
    if (is_numbered && fonts) set_fonts(figure, *fonts);
    if (fonts) add_annotations(figure, annotated, scale, *fonts);
    return figure;
  };
  const auto explained_on = [&](const TitledPage& titled, const LegendStrip& strip) {
    if (!fonts) return Explanations();
    const double covered_above = titled.title.drawing.height;
    return explain(request, source, seen_plane(titled.page, scale), covered_above, entries, strip, *fonts);
  };
  // The page without title and strip, if what is drawn on a larger one decides it.
  std::optional<figure::Page> tight;
  if (request.is_tight) {
    tight = page_for(request, source);
    const Box2 ink = figure::ink_box(drawn_on(*tight, explained_on({*tight, {}}, {}).annotated));
    if (!ink.is_empty() && ink.width() > 0.0 && ink.height() > 0.0) tight = figure::part_of(*tight, ink);
  }
  const auto laid_out = [&](const LegendStrip& strip) {
    PageEdges edges{.below = whole_pixels(points * strip.below), .right = whole_pixels(points * strip.right)};
    const auto page = [&] { return with_edges(tight ? *tight : page_for(within(request, edges), source), edges); };
    TitledPage titled{page(), {}};
    if (!fonts || request.title.empty()) return titled;
    titled.title = title_on(titled.page, request, *fonts);
    edges.above = whole_pixels(points * titled.title.drawing.height);
    titled.page = page();
    return titled;
  };
  LegendStrip strip;
  if (request.legend_beside && !request.legend_at && !entries.empty() && fonts)
    strip = strip_for_legend([&](const LegendStrip& tried) {
      const TitledPage titled = laid_out(tried);
      const figure::Page& page = titled.page;
      return LegendTrial{explained_on(titled, tried).legend, page.width / points, page.height / points,
                         page.units_per_point};
    });
  const TitledPage titled = laid_out(strip);
  if (!entries.empty()) {
    // The legend shows lines and points as wide as they are drawn on this page.
    const std::vector<render::LayerView> drawn =
        views_of(request.shown, spacing / (titled.page.units_per_point * points));
    figure::Drawing on_page = explained;
    on_page.views = drawn;
    entries = legend_of(on_page, request.legend);
  }
  const Explanations around = explained_on(titled, strip);
  if (!titled.title.complaint.empty()) out.remarks.push_back("the title: " + titled.title.complaint);
  out.figure = drawn_on(titled.page, around.annotated);
  if (auto good = figure::rasterize_layers(out.figure, request.rasterized, request.dots_per_inch); !good)
    return std::unexpected(good.error());
  out.remarks.insert(out.remarks.end(), around.annotated.complaints.begin(), around.annotated.complaints.end());
  if (!fonts) return out;
  if (!around.marks.is_empty())
    add_to(out.figure, *fonts,
           layout_scale_marks(around.marks, around.plane, measure_with(*fonts, scale), request.shown.background),
           {0.0, 0.0}, scale);
  if (!titled.title.drawing.is_empty()) add_to(out.figure, *fonts, titled.title.drawing, {0.0, 0.0}, scale);
  const PlacedLegend& legend = around.legend;
  if (!legend.drawing.is_empty())
    add_to(out.figure, *fonts, legend.drawing, points * legend.corner, scale * legend.shrink);
  if (legend.lacks_room) out.remarks.push_back(kLegendLacksRoom);
  LackingLetters lacking;
  lacking.look_at(out.figure);
  if (std::string words = lacking.words(); !words.empty()) out.remarks.push_back(std::move(words));
  return out;
}

std::string tex_warning(std::size_t shapes, std::string_view extension) {
  if (extension != ".tex" || shapes <= kMostTexShapes) return {};
  constexpr std::size_t kShapesAMinute = 80'000;
  return fmt::format(
      "the figure has {} shapes, for which pdflatex takes some {} minutes: show less, or write PDF and include that",
      shapes, shapes / kShapesAMinute + 1);
}

}  // namespace mes

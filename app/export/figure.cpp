// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/figure.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/editing/sample_spacing.h"
#include "app/picture/figure_legend.h"
#include "app/picture/lacking_letters.h"
#include "app/picture/sample_texts.h"
#include "app/picture/scale_drawing.h"
#include "app/picture/shapes_below.h"
#include "app/picture/title_drawing.h"
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

/// The request for the part below a band of this many points. If the height of the page follows from its content, the
/// content keeps its full height.
FigureRequest below(FigureRequest request, double band) {
  if (request.page && request.page->height) *request.page->height -= band;
  if (!request.page && !std::holds_alternative<figure::Page>(request.part))
    request.pixels[1] -= static_cast<int>(std::lround(band / figure::kPointsPerPixel));
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

/// The height of the title's band in points, rounded up to whole pixels of 1/96 inch.
double band_of(const PictureTitle& title, const FigureRequest& request) {
  return figure::kPointsPerPixel * std::ceil(request.shown.scale * title.drawing.height);
}

SeenPlane plane_below(const PictureTitle& title, const figure::Page& page, double scale) {
  SeenPlane plane = seen_plane(page, scale);
  plane.covered_above = title.drawing.height;
  return plane;
}

/// Adds the scale marks, and returns their positions.
MarksPlace add_scale_marks(figure::Figure& figure, const SeenPlane& plane, const FigureRequest& request,
                           const LegendSurroundings& around, const PaperFonts& fonts) {
  const double scale = request.shown.scale;
  const MeasureText measure = measure_with(fonts, scale);
  const ScaleMarks marks =
      with_free_bar(request.marks, plane, measure, [&](const Box2& box) { return around.cost_of(box); });
  if (!marks.is_empty())
    add_to(figure, fonts, layout_scale_marks(marks, plane, measure, request.shown.background), {0.0, 0.0}, scale);
  return place_of_marks(marks, plane, measure);
}

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
AnnotationDrawing add_annotations(figure::Figure& figure, const figure::Page& page, const FigureRequest& request,
                                  const PlacedAnnotations& annotations, const PaperFonts& fonts) {
  const double scale = request.shown.scale;
  AnnotationDrawing drawn =
      layout_annotations(annotations, seen_plane(page, scale), measure_with(fonts, scale), request.shown.background);
  const double points = scale * figure::kPointsPerPixel;
  if (!drawn.highlights.is_empty())
    add_layer(figure, fonts, drawn.highlights, {0.0, 0.0}, scale,
              {.id = "highlights", .title = "Highlights", .line_width = kHighlightLine * points});
  if (drawn.drawing.is_empty()) return drawn;
  add_layer(figure, fonts, drawn.drawing, {0.0, 0.0}, scale,
            {.id = "annotations", .title = "Annotations", .line_width = kAnnotationLine * points});
  return drawn;
}

}  // namespace

const figure::FigureLayer* largest_layer(const figure::Figure& figure) {
  const auto largest = std::ranges::max_element(
      figure.layers, {}, [](const figure::FigureLayer& layer) { return figure::shape_count(layer); });
  return largest != figure.layers.end() && figure::shape_count(*largest) != 0 ? &*largest : nullptr;
}

Expected<DrawnFigure> draw_figure(const FigureRequest& request, const FigureSource& source) {
  figure::Page page = page_for(request, source);
  const std::vector<render::LayerView> views = views_of(request.shown, 0.0);
  const figure::Drawing explained{.mirror = source.mirror,
                                  .layers = request.shown.descriptors,
                                  .views = views,
                                  .maps = source.maps,
                                  .background = request.shown.background,
                                  .scale = request.shown.scale,
                                  .traced = {find_layer(request.shown.descriptors, "image"),
                                             source.traced,
                                             {request.image.center, request.image.width}}};
  const bool is_annotated = request.with_annotations && !source.annotations.is_empty();
  const bool is_explained = has_legend(explained, request.legend);
  const bool is_numbered = has_texts(request.shown);
  std::optional<PaperFonts> fonts;
  DrawnFigure out;
  if (is_annotated || is_explained || is_numbered || !request.title.empty() || !request.marks.is_empty()) {
    if (auto read = PaperFonts::read(find_assets({})))
      fonts = std::move(*read);
    else
      out.remarks.push_back("title, annotations, numbers, legend, scale bar and axes are left out: " +
                            read.error().message());
  }
  PictureTitle title;
  if (fonts) title = title_on(page, request, *fonts);
  if (!title.complaint.empty()) out.remarks.push_back("the title: " + title.complaint);
  if (const double band = band_of(title, request); band > 0.0 && !request.is_tight)
    page = with_band(page_for(below(request, band), source), band);
  AnnotationDrawing annotated;
  const double spacing = typical_spacing(source.document);
  const auto drawn_on_page = [&] {
    const double units_per_px = page.units_per_point * figure::kPointsPerPixel * request.shown.scale;
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
    if (is_annotated && fonts) annotated = add_annotations(figure, page, request, source.annotations, *fonts);
    return figure;
  };
  out.figure = drawn_on_page();
  if (request.is_tight) {
    const Box2 ink = figure::ink_box(out.figure);
    if (!ink.is_empty() && ink.width() > 0.0 && ink.height() > 0.0) {
      page = figure::part_of(page, ink);
      if (fonts) title = title_on(page, request, *fonts);
    }
    page = with_band(page, band_of(title, request));
    out.figure = drawn_on_page();
  }
  if (auto good = figure::rasterize_layers(out.figure, request.rasterized, request.dots_per_inch); !good)
    return std::unexpected(good.error());
  out.remarks.insert(out.remarks.end(), annotated.complaints.begin(), annotated.complaints.end());
  if (!fonts) return out;
  const SeenPlane plane = plane_below(title, page, request.shown.scale);
  LegendSurroundings around{
      .place = request.legend_at,
      .words = annotated.words,
      .hides = [&](const Box2& box) { return shapes_below(source.mirror, request.shown.layers, below(plane, box)); },
      .keeps_letters = request.keeps_letters};
  const MarksPlace marks = add_scale_marks(out.figure, plane, request, around, *fonts);
  around.room = marks.room;
  around.bar = marks.longest_bar;
  if (!title.drawing.is_empty()) add_to(out.figure, *fonts, title.drawing, {0.0, 0.0}, request.shown.scale);
  if (!add_legend(out.figure, explained, request.legend, around, *fonts)) out.remarks.push_back(kLegendLacksRoom);
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

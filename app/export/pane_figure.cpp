// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/pane_figure.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/picture/paper/lacking_letters.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/picture/paper/title_drawing.h"
#include "app/store/sample_shapes.h"
#include "render/camera.h"

namespace mes {
namespace {

/// The size of the page; if it has no height, it gets the height that the panes fill.
PageSize pane_page(const FigureRequest& request, std::size_t panes, double proportions, double unit) {
  const auto* const natural = std::get_if<figure::Page>(&request.part);
  const PageSize own = natural != nullptr ? PageSize{natural->width, natural->height}
                                          : PageSize{figure::kPointsPerPixel * request.pixels[0],
                                                     figure::kPointsPerPixel * request.pixels[1]};
  PageSize page = request.page.value_or(own);
  if (page.height) return page;
  const std::size_t columns = usual_columns(panes);
  const double gaps = lay_out_panes_of(0.0, 0.0, panes, columns, unit).gap * static_cast<double>(columns - 1);
  const double width = (page.width - gaps) / static_cast<double>(columns);
  page.height = lay_out_panes_of(width, proportions * width, panes, columns, unit).extent().y;
  return page;
}

/// The part that each pane shows, on a page of its size.
figure::Page part_for(const FigureRequest& request, const SeenByAll& seen, const PaneGrid& grid) {
  if (const auto* const natural = std::get_if<figure::Page>(&request.part))
    return resized(*natural, {grid.pane_width, grid.pane_height});
  // The cameras of panes have whole pixels, fine enough that their rounding is invisible.
  constexpr double kPixelsPerPoint = 64.0;
  EdgeRoom edges;
  if (request.marks.axes && seen.margin > 0.0)
    edges = room_of_axes(kPixelsPerPoint * figure::kPointsPerPixel * request.shown.scale);
  const render::Camera camera =
      camera_within(edges, static_cast<int>(std::lround(kPixelsPerPoint * grid.pane_width)),
                    static_cast<int>(std::lround(kPixelsPerPoint * grid.pane_height)), seen.box, seen.margin);
  figure::Page part = figure::page_of(camera, grid.pane_width);
  part.height = grid.pane_height;
  return part;
}

ShownPanes::Layers layers_of(const ShownLayers& shown) {
  ShownPanes::Layers out;
  for (const VariantLayer layer : shown.layers) out.emplace_back(layer, shown.styles[layer.layer]);
  return out;
}

/// The area that a pane with its own camera shows.
SeenByAll seen_in(const Comparison& comparison, std::span<const FigureSource> sources, std::size_t pane,
                  const FigureRequest& request) {
  if (const Box2* const view = std::get_if<Box2>(&request.part)) return {*view, 0.0};
  return seen_alone(comparison, sources, pane);
}

std::vector<std::string> labels_of(const Comparison& comparison) {
  std::vector<std::string> out;
  for (const Pane& pane : comparison.panes) out.push_back(pane.label);
  return out;
}

}  // namespace

double SeenByAll::proportions() const {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 10.0;
  if (box.is_empty() || !(box.width() > 0.0)) return 1.0;
  return std::clamp(box.height() / box.width(), kLeast, kMost);
}

SeenByAll seen_alone(const Comparison& comparison, std::span<const FigureSource> sources, std::size_t pane) {
  return {fit_box(comparison.panes[pane].shown.descriptors, sources[pane].bounds, sources[pane].mirror,
                  comparison.panes[pane].shown.layers),
          kFitMargin};
}

SeenByAll seen_by_all(const Comparison& comparison, std::span<const FigureSource> sources,
                      const std::optional<Box2>& view) {
  if (view) return {*view, 0.0};
  SeenByAll out{{}, kFitMargin};
  for (std::size_t i = 0; i < comparison.panes.size(); ++i)
    if (const Box2 box = seen_alone(comparison, sources, i).box; !box.is_empty()) out.box.add(box);
  return out;
}

FigureRequest request_for(const FigureRequest& all, const Comparison& comparison, std::size_t pane,
                          bool are_cameras_free) {
  FigureRequest out = all;
  out.title.clear();
  // All panes show the same part of the plane.
  out.legend_beside = false;
  if (pane == 0) return out;
  if (!are_cameras_free) out.marks.bar = false;
  std::vector<ShownPanes::Layers> layers;
  for (const Pane& each : comparison.panes) layers.push_back(layers_of(each.shown));
  if (are_alike(layers)) out.legend = LegendScope::none;
  return out;
}

std::string id_prefix_of(const Pane& pane) {
  return "pane-" + pane.letter + '-';
}

std::string title_prefix_of(const Pane& pane) {
  return '(' + pane.letter + ") ";
}

std::unexpected<Error> no_room_for(std::size_t panes) {
  return std::unexpected(
      Error{ErrorCode::usage, fmt::format("the picture is too small for {} panes", panes), {}, 0, 0});
}

Expected<DrawnFigure> draw_pane_figure(const FigureRequest& request, const Comparison& comparison,
                                       std::span<const FigureSource> sources,
                                       const std::optional<FreeCameras>& cameras) {
  constexpr double kLeastSide = 12.0;
  const double scale = request.shown.scale;
  const double unit = scale * figure::kPointsPerPixel;
  const bool is_height_free = request.page && !request.page->height;
  const std::size_t count = comparison.panes.size();
  const auto* const natural = std::get_if<figure::Page>(&request.part);
  SeenByAll seen;
  if (natural == nullptr) {
    const Box2* const view = std::get_if<Box2>(&request.part);
    seen = seen_by_all(comparison, sources, view != nullptr ? std::optional(*view) : std::nullopt);
  }
  const double proportions = natural != nullptr ? natural->height / natural->width : seen.proportions();
  auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return std::unexpected(fonts.error());
  DrawnFigure out;
  PageSize page = pane_page(request, count, proportions, unit);
  const MeasureText measure = measure_with(*fonts, scale);
  const PictureTitle title =
      layout_title(request.title, page.width / unit, *page.height / unit, measure, request.shown.background);
  if (!title.complaint.empty()) out.remarks.push_back("the title: " + title.complaint);
  const double band = figure::kPointsPerPixel * std::ceil(scale * title.drawing.height);
  if (is_height_free) *page.height += band;
  const PaneGrid grid = lay_out(count, page.width, *page.height - band, proportions, unit);
  if (grid.pane_width < kLeastSide || grid.pane_height < kLeastSide) return no_room_for(count);
  const auto part_of_pane = [&](std::size_t pane, const PaneGrid& on) {
    if (!cameras) return part_for(request, seen, on);
    if (natural != nullptr && pane < cameras->views.size())
      return resized(cameras->views[pane], {on.pane_width, on.pane_height});
    return part_for(request, natural == nullptr ? seen_in(comparison, sources, pane, request) : seen, on);
  };
  out.figure.width = page.width;
  out.figure.height = *page.height;
  out.figure.background = request.shown.background;
  for (std::size_t i = 0; i < count; ++i) {
    const Pane& pane = comparison.panes[i];
    FigureRequest one = request_for(request, comparison, i, cameras.has_value());
    const std::optional<Rgb> background = request.shown.background;
    one.shown = pane.shown;
    one.shown.background = background;
    one.shown.scale = scale;
    one.part = part_of_pane(i, grid);
    one.page.reset();
    one.is_tight = false;
    one.marks_above = pane.marks;
    auto drawn = draw_figure(one, sources[i]);
    if (!drawn) return drawn;
    figure::place(out.figure, std::move(drawn->figure), grid.corner(i) + Vec2{0.0, band}, id_prefix_of(pane),
                  title_prefix_of(pane));
    out.remarks.insert(out.remarks.end(), drawn->remarks.begin(), drawn->remarks.end());
  }
  const PaperDrawing labels =
      layout_pane_labels(labels_of(comparison), grid.scaled(1.0 / unit), measure, request.shown.background);
  add_layer(out.figure, *fonts, labels, {0.0, band}, scale,
            {.id = std::string(kPaneLabels), .title = "Panes", .line_width = kPaneFrame * unit});
  if (!title.drawing.is_empty()) add_to(out.figure, *fonts, title.drawing, {0.0, 0.0}, scale);
  LackingLetters lacking;
  lacking.look_at(*fonts, labels);
  lacking.look_at(*fonts, title.drawing);
  if (std::string words = lacking.words(); !words.empty()) out.remarks.push_back(std::move(words));
  return out;
}

}  // namespace mes

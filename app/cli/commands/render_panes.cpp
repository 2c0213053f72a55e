// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/render_panes.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/cli/console/messages.h"
#include "app/export/pane_figure.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/store/sample_shapes.h"

namespace mes::cli {
namespace {

/// Everything from which panes are drawn.
struct DrawnPanes {
  const Comparison& comparison;
  const std::vector<FigureSource>& sources;  // one per pane
  const PictureRequest& picture;
  const RenderRequest& request;
  SeenByAll seen;
};

Expected<render::Image> draw_panes_in_pixels(const DrawnPanes& panes, Canvas& canvas) {
  constexpr int kLeastSide = 16;
  const auto& [width, height] = panes.picture.size;
  const std::size_t count = panes.comparison.panes.size();
  const double scale = panes.picture.shown.scale;
  TitleBand title = title_of(panes.request, panes.picture.size, panes.picture.shown);
  PaneSheet sheet{.width = width,
                  .height = height,
                  .band = title.pixels,
                  .scale = scale,
                  .background = panes.picture.shown.background,
                  .grid = lay_out(count, width, height - title.pixels, panes.seen.proportions(), scale)};
  const PictureSize size{sheet.pane_width(), sheet.pane_height()};
  if (size.width < kLeastSide || size.height < kLeastSide) return no_room_for(count);
  const auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return std::unexpected(fonts.error());
  const FigureRequest all = figure_request(panes.picture, panes.request);
  std::vector<render::Image> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const Pane& pane = panes.comparison.panes[i];
    const bool is_free = panes.request.has_free_cameras;
    const SeenByAll seen = is_free ? seen_alone(panes.comparison, panes.sources, i) : panes.seen;
    FigureRequest one = request_for(all, panes.comparison, i, is_free);
    one.shown = pane.shown;
    one.marks_above = pane.marks;
    auto part = draw_pixels(canvas, {camera_for(size, {seen.box, seen.margin}, all.marks.axes, scale)},
                            panes.sources[i], one);
    if (!part) return part;
    parts.push_back(std::move(*part));
    sheet.labels.push_back(pane.label);
  }
  sheet.title = std::move(title.drawing);
  return sheet.with(parts, *fonts);
}

}  // namespace

Expected<std::string> draw_panes(const PictureRequest& picture, const RenderRequest& request, Comparison& comparison,
                                 const ComputationResult& result, Canvas* canvas, LayerMirror& mirror,
                                 const FigureSource& common, std::string session) {
  share_color_ranges(comparison, mirror);
  std::vector<FigureSource> sources;
  std::vector<Box2> bounds(comparison.panes.size());
  for (std::size_t i = 0; i < comparison.panes.size(); ++i) {
    const Pane& pane = comparison.panes[i];
    const Document& document = comparison.document_of(pane, result);
    bounds[i] = document.bounding_box();
    sources.push_back({.mirror = mirror,
                       .bounds = bounds[i],
                       .maps = common.maps,
                       .traced = common.traced,
                       .annotations = request.with_annotations ? place(document) : PlacedAnnotations{},
                       .document = document});
  }
  const bool is_free = request.has_free_cameras;
  // The view of a session is that of the main pane.
  const SeenByAll seen = seen_by_all(comparison, sources, is_free ? std::nullopt : picture.view);
  if (request.with_differences) {
    const FramePatch patch = mark_differences(
        comparison, mirror, seen.box.is_empty() ? 0.0 : std::max(seen.box.width(), seen.box.height()));
    mirror.apply(patch);
    if (canvas != nullptr) canvas->scene.apply(patch);
    if (patch.layer_count == 0) say("the panes show no differences");
  }
  if (canvas != nullptr) {
    const auto image = draw_panes_in_pixels({comparison, sources, picture, request, seen}, *canvas);
    if (!image) return std::unexpected(image.error());
    return encoded(*image, session);
  }
  FigureRequest figure = figure_request(picture, request);
  if (is_free) figure.part = Everything{};
  auto drawn = draw_pane_figure(figure, comparison, sources, is_free ? std::optional(FreeCameras{}) : std::nullopt);
  if (!drawn) return std::unexpected(drawn.error());
  return written(picture, std::move(*drawn), common.traced != nullptr, std::move(session));
}

}  // namespace mes::cli

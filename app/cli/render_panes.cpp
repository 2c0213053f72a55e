// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/render_panes.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/messages.h"
#include "app/export/page_size.h"
#include "app/picture/title_drawing.h"
#include "app/store/sample_shapes.h"

namespace mes::cli {
namespace {

/// A picture of one colour; without one it is transparent.
render::Image plain_image(int width, int height, const std::optional<Rgb>& color) {
  render::Image out{width, height, {}};
  out.rgba.resize(out.offset(0, height));
  if (!color) return out;
  const std::array<std::uint8_t, 4> pixel{color->r, color->g, color->b, 0xFF};
  for (std::size_t at = 0; at < out.rgba.size(); at += pixel.size())
    std::ranges::copy(pixel, out.rgba.begin() + static_cast<std::ptrdiff_t>(at));
  return out;
}

/// Takes the place of the pixels from (x, y) on.
void paste(const render::Image& part, render::Image& image, int x, int y) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(part.offset(part.width, 0));
  for (int row = 0; row < part.height; ++row) {
    const auto from = part.rgba.begin() + static_cast<std::ptrdiff_t>(part.offset(0, row));
    std::copy(from, from + row_bytes, image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(x, y + row)));
  }
}

/// Everything that panes are drawn from.
struct DrawnPanes {
  const Comparison& comparison;
  const std::vector<FigureSource>& sources;  // of each
  const PictureRequest& picture;
  const RenderRequest& request;
  Seen seen;
};

/// What one pane shows beside the drawing. The title stands above all of them; a scale bar, and a legend that is the
/// same in all, stand in the first only.
RenderRequest request_for(const DrawnPanes& panes, std::size_t pane) {
  RenderRequest out = panes.request;
  out.title.clear();
  if (pane == 0) return out;
  out.marks.bar = false;
  const auto plain = [](const Pane& of) {
    std::vector<LayerIndex> layers = of.shown.layers;
    std::ranges::transform(layers, layers.begin(), plain_layer);
    return layers;
  };
  const bool is_alike = std::ranges::all_of(panes.comparison.panes, [&](const Pane& each) {
    return plain(each) == plain(panes.comparison.panes.front()) &&
           each.shown.styles == panes.comparison.panes.front().shown.styles;
  });
  if (is_alike) out.with_legend = out.with_key = false;
  return out;
}

/// The height of what is seen by its width.
double proportions_of(const Seen& seen) {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 10.0;
  if (seen.box.is_empty() || !(seen.box.width() > 0.0)) return 1.0;
  return std::clamp(seen.box.height() / seen.box.width(), kLeast, kMost);
}

std::unexpected<Error> no_room_for(std::size_t panes) {
  return usage_error(fmt::format("the picture is too small for {} panes", panes));
}

Expected<render::Image> draw_panes_in_pixels(const DrawnPanes& panes, Canvas& canvas) {
  constexpr int kLeastSide = 16;
  const auto& [width, height] = panes.picture.size;
  const double scale = panes.picture.shown.scale;
  const TitleBand title = title_of(panes.request, panes.picture.size, panes.picture.shown);
  const PaneGrid grid =
      lay_out(panes.comparison.panes.size(), width, height - title.pixels, proportions_of(panes.seen), scale);
  const PictureSize size{static_cast<int>(grid.pane_width), static_cast<int>(grid.pane_height)};
  if (size.width < kLeastSide || size.height < kLeastSide) return no_room_for(panes.comparison.panes.size());
  const auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return std::unexpected(fonts.error());
  render::Image image = plain_image(width, height, panes.picture.shown.background);
  for (std::size_t i = 0; i < panes.comparison.panes.size(); ++i) {
    const Pane& pane = panes.comparison.panes[i];
    const auto part = draw_pixels(pane.shown, pane.marks, canvas, camera_for(size, panes.seen), panes.sources[i],
                                  request_for(panes, i), {});
    if (!part) return part;
    const Vec2 corner = grid.corner(i);
    paste(*part, image, static_cast<int>(corner.x), title.pixels + static_cast<int>(corner.y));
  }
  PaneGrid logical = grid;
  for (double* const length : {&logical.pane_width, &logical.pane_height, &logical.gap, &logical.band})
    *length /= scale;
  paint(image, *fonts,
        layout_pane_labels(panes.comparison, logical, measure_with(*fonts, scale), panes.picture.shown.background),
        {0.0, title.pixels}, scale);
  paint(image, *fonts, title.drawing, {0.0, 0.0}, scale);
  return image;
}

/// Without a height, that with which panes fill the page.
PageSize page_for(const PictureRequest& picture, std::size_t panes, double proportions, double unit) {
  PageSize page = picture.page.value_or(
      PageSize{figure::kPointsPerPixel * picture.size.width, figure::kPointsPerPixel * picture.size.height});
  if (page.height) return page;
  // In rows of up to three, or as a square.
  constexpr std::size_t kInARow = 3;
  const std::size_t columns =
      panes <= kInARow ? panes : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(panes))));
  const std::size_t rows = (panes + columns - 1) / columns;
  const PaneGrid lengths = lay_out(1, page.width, page.width, 1.0, unit);
  const double pane = (page.width - static_cast<double>(columns - 1) * lengths.gap) / static_cast<double>(columns);
  page.height =
      static_cast<double>(rows) * (proportions * pane + lengths.band) + static_cast<double>(rows - 1) * lengths.gap;
  return page;
}

Expected<DrawnFigure> draw_panes_in_vectors(const DrawnPanes& panes) {
  constexpr double kLeastSide = 12.0;
  const double scale = panes.picture.shown.scale;
  const double unit = scale * figure::kPointsPerPixel;
  const bool is_height_free = panes.picture.page && !panes.picture.page->height;
  const std::size_t count = panes.comparison.panes.size();
  const double proportions = proportions_of(panes.seen);
  auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return std::unexpected(fonts.error());
  DrawnFigure out;
  PageSize page = page_for(panes.picture, count, proportions, unit);
  const PictureTitle title = layout_title(panes.request.title, page.width / unit, *page.height / unit,
                                          measure_with(*fonts, scale), panes.picture.shown.background);
  if (!title.complaint.empty()) out.remarks.push_back("the title: " + title.complaint);
  const double band = figure::kPointsPerPixel * std::ceil(scale * title.drawing.height);
  if (is_height_free) *page.height += band;
  const PaneGrid grid = lay_out(count, page.width, *page.height - band, proportions, unit);
  if (grid.pane_width < kLeastSide || grid.pane_height < kLeastSide) return no_room_for(count);
  out.figure.width = page.width;
  out.figure.height = *page.height;
  out.figure.background = panes.picture.shown.background;
  // Panes are seen through cameras of whole pixels, fine enough that their rounding cannot be seen.
  constexpr double kPixelsPerPoint = 64.0;
  const PictureSize size{static_cast<int>(std::lround(kPixelsPerPoint * grid.pane_width)),
                         static_cast<int>(std::lround(kPixelsPerPoint * grid.pane_height))};
  figure::Page part = figure::page_of(camera_for(size, panes.seen), grid.pane_width);
  part.height = grid.pane_height;
  for (std::size_t i = 0; i < count; ++i) {
    const Pane& pane = panes.comparison.panes[i];
    FigureRequest request = figure_request(panes.picture, request_for(panes, i));
    request.shown = pane.shown;
    request.part = part;
    request.page.reset();
    request.marks_above = pane.marks;
    auto drawn = draw_figure(request, panes.sources[i]);
    if (!drawn) return drawn;
    figure::place(out.figure, std::move(drawn->figure), grid.corner(i) + Vec2{0.0, band}, "pane-" + pane.letter + '-',
                  '(' + pane.letter + ") ");
    out.remarks.insert(out.remarks.end(), drawn->remarks.begin(), drawn->remarks.end());
  }
  PaneGrid logical = grid;
  for (double* const length : {&logical.pane_width, &logical.pane_height, &logical.gap, &logical.band})
    *length /= unit;
  add_layer(
      out.figure, *fonts,
      layout_pane_labels(panes.comparison, logical, measure_with(*fonts, scale), panes.picture.shown.background),
      {0.0, band}, scale, {.id = "panes", .title = "Panes", .line_width = kPaneFrame * unit});
  if (!title.drawing.is_empty()) add_to(out.figure, *fonts, title.drawing, {0.0, 0.0}, scale);
  return out;
}

}  // namespace

Expected<std::string> draw_panes(const PictureRequest& picture, const RenderRequest& request, Comparison& comparison,
                                 const ComputationResult& result, Canvas* canvas, LayerMirror& mirror,
                                 const FigureSource& common, std::string session) {
  share_color_ranges(comparison, mirror);
  std::vector<FigureSource> sources;
  std::vector<Box2> bounds(comparison.panes.size());
  DrawnPanes panes{comparison, sources, picture, request, {}};
  for (std::size_t i = 0; i < comparison.panes.size(); ++i) {
    const Pane& pane = comparison.panes[i];
    const Document& document = comparison.document_of(pane, result);
    bounds[i] = document.bounding_box();
    PictureRequest one = picture;
    one.shown = pane.shown;
    const Seen seen = seen_by(one, bounds[i], mirror);
    if (!seen.box.is_empty()) {
      panes.seen.box.add(seen.box);
      panes.seen.margin = seen.margin;
    }
    sources.push_back({.mirror = mirror,
                       .samples = pane.data->positions,
                       .bounds = bounds[i],
                       .maps = common.maps,
                       .traced = common.traced,
                       .annotations = request.with_annotations ? place(document) : PlacedAnnotations{},
                       .document = document});
  }
  if (request.with_differences) {
    const Box2& box = panes.seen.box;
    const FramePatch patch =
        mark_differences(comparison, mirror, box.is_empty() ? 0.0 : std::max(box.width(), box.height()));
    mirror.apply(patch);
    if (canvas != nullptr) canvas->scene.apply(patch);
    if (patch.layer_count == 0) say("the panes show no differences");
  }
  if (canvas != nullptr) {
    const auto image = draw_panes_in_pixels(panes, *canvas);
    if (!image) return std::unexpected(image.error());
    return encoded(*image, session);
  }
  auto drawn = draw_panes_in_vectors(panes);
  if (!drawn) return std::unexpected(drawn.error());
  return written(picture, std::move(*drawn), common.traced != nullptr, std::move(session));
}

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/figure.h"

#include <algorithm>
#include <cmath>

#include "app/cli/messages.h"
#include "app/picture/figure_legend.h"
#include "app/store/background_loader.h"
#include "app/store/sample_shapes.h"
#include "core/draw/layer_descriptor.h"
#include "render/camera.h"
#include "render/figure/figure_of.h"

namespace mes::cli {
namespace {

/// What the page shows: the view as asked for, or what "fit" shows.
struct Shown {
  Box2 box;
  double margin = 0.0;  // as a part of the shorter side
};

Shown shown_by(const PictureRequest& request, const FigureSource& source) {
  if (request.view) return {*request.view, 0.0};
  return {fit_box(source.bounds, source.mirror, request.layers), kFitMargin};
}

/// The height of a page such that what is shown fills it, margins included.
double natural_height(const Shown& shown, double width) {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 3.0;
  const double ratio = shown.box.is_empty() || !(shown.box.width() > 0.0)
                           ? 1.0
                           : std::clamp(shown.box.height() / shown.box.width(), kLeast, kMost);
  const double both = 2.0 * shown.margin;
  // The margin is a part of the shorter side, which is the height if the ratio is below 1.
  return ratio < 1.0 ? ratio * width / (1.0 - both + both * ratio) : (1.0 - both) * width * ratio + both * width;
}

figure::Page page_for(const PictureRequest& request, const Shown& shown) {
  render::Camera camera;
  if (!request.page) {
    camera.set_viewport(request.size.width, request.size.height);
    camera.fit(shown.box, shown.margin * std::min(request.size.width, request.size.height));
    return figure::page_of(camera);
  }
  // A camera counts whole pixels: enough of them that the rounding of the page's sides cannot be seen.
  constexpr double kPixelsPerPoint = 64.0;
  const double width = request.page->width;
  const double height = request.page->height.value_or(natural_height(shown, width));
  const auto pixels = [](double points) { return static_cast<int>(std::lround(kPixelsPerPoint * points)); };
  camera.set_viewport(pixels(width), pixels(height));
  camera.fit(shown.box, shown.margin * std::min(camera.width(), camera.height()));
  figure::Page page = figure::page_of(camera, width);
  page.height = height;
  return page;
}

}  // namespace

Expected<std::string> draw_figure(const PictureRequest& request, const FigureSource& source) {
  figure::Page page = page_for(request, shown_by(request, source));
  const std::vector<render::LayerView> views =
      views_of(request, page.units_per_point * figure::kPointsPerPixel, source.samples);
  const figure::Drawing drawing{
      .mirror = source.mirror,
      .layers = layer_descriptors(),
      .views = views,
      .maps = source.maps,
      .background = request.background,
      .scale = request.scale,
      .traced = {find_layer("image"), source.traced, {request.image.center, request.image.width}}};
  figure::Figure figure = figure::figure_of(drawing, page);
  if (request.is_tight) {
    const Box2 ink = figure::ink_box(figure);
    if (!ink.is_empty() && ink.width() > 0.0 && ink.height() > 0.0) {
      page = figure::part_of(page, ink);
      figure = figure::figure_of(drawing, page);
    }
  }
  if (source.traced != nullptr && !request.format->has_images)
    say("the picture " + request.image.file + " is left out: " + std::string(request.format->name) +
        " files hold none");
  if (source.with_legend && has_legend(drawing)) {
    if (const auto fonts = LegendFonts::read(find_assets({})))
      add_legend(figure, drawing, *fonts);
    else
      say("the legend is left out: " + fonts.error().message());
  }
  return request.format->write(figure);
}

}  // namespace mes::cli

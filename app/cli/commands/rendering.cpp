// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/rendering.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "app/cli/console/messages.h"
#include "app/cli/console/progress.h"
#include "app/editing/curves/sample_spacing.h"
#include "app/export/explanations.h"
#include "app/picture/paper/lacking_letters.h"
#include "app/picture/paper/title_drawing.h"
#include "app/picture/sample_texts.h"
#include "app/store/sample_shapes.h"
#include "render/image/png.h"
#include "render/offscreen.h"

namespace mes::cli {
namespace {

/// `spacing_px` between samples makes the lines of the legend as thin as they are drawn; 0 leaves them as they are.
std::vector<LegendEntry> entries_in(const render::Scene& scene, const FigureRequest& request, double spacing_px) {
  return legend_of(request.shown.descriptors, scene, views_of(request.shown, spacing_px), request.legend);
}

/// Adds the explanations on top of the finished picture.
void add_paper(render::Image& image, const render::Scene& scene, const PictureLayout& layout,
               const FigureSource& source, const FigureRequest& request, const PaperFonts& fonts) {
  const double scale = request.shown.scale;
  const PaperDrawing& title = layout.title.drawing;
  const double spacing_px = typical_spacing(source.document) / (layout.camera.units_per_pixel() * scale);
  const Explanations around = explain(request, source, seen_plane(layout.camera, scale), title.height,
                                      entries_in(scene, request, spacing_px), layout.strip, fonts);
  for (const std::string& complaint : around.annotated.complaints) say(complaint);
  paint(image, fonts, around.annotated.highlights, {0.0, 0.0}, scale);
  paint(image, fonts, around.annotated.drawing, {0.0, 0.0}, scale);
  if (!around.marks.is_empty())
    paint(image, fonts,
          layout_scale_marks(around.marks, around.plane, measure_with(fonts, scale), request.shown.background),
          {0.0, 0.0}, scale);
  paint(image, fonts, title, {0.0, 0.0}, scale);
  LackingLetters lacking;
  lacking.look_at(fonts, around.annotated.drawing);
  lacking.look_at(fonts, title);
  if (const std::string words = lacking.words(); !words.empty()) say(words);
  paint(image, fonts, around.legend, scale);
  if (around.legend.lacks_room) say(kLegendLacksRoom);
}

/// Draws in bands from the top if there is much to draw, so that a terminal shows the progress. Bands meet without a
/// seam.
Expected<render::Image> draw_in_bands(render::Device& device, render::Scene& scene, const render::Camera& camera,
                                      std::span<const render::LayerView> views, const render::ImageOptions& options) {
  constexpr std::uint64_t kMuch = 50'000;
  constexpr int kBands = 8;
  std::uint64_t instances = 0;
  for (const render::LayerView& view : views)
    for (const PrimitiveKind kind : kAllPrimitiveKinds) instances += scene.instances(view.layer, kind);
  const int height = camera.height();
  if (instances < kMuch || height < 2 * kBands) return render::draw_image(device, scene, camera, views, options);

  Progress progress;
  render::Image image{camera.width(), height, {}};
  for (int band = 0; band < kBands; ++band) {
    const int top = band * height / kBands;
    const int bottom = (band + 1) * height / kBands;
    const auto part =
        render::draw_image(device, scene, camera.part(0, top, camera.width(), bottom - top), views, options);
    if (!part) return part;
    image.rgba.insert(image.rgba.end(), part->rgba.begin(), part->rgba.end());
    progress.show("drawing", static_cast<double>(band + 1) / kBands);
  }
  return image;
}

}  // namespace

Seen seen_by(const PictureRequest& picture, const Box2& samples, const LayerMirror& mirror) {
  if (picture.view) return {*picture.view, 0.0};
  return {fit_box(picture.shown.descriptors, samples, mirror, picture.shown.layers), kFitMargin};
}

render::Camera camera_for(const PictureSize& size, const Seen& seen, bool has_axes, double scale,
                          const EdgeRoom& taken) {
  EdgeRoom edges = taken;
  if (has_axes && seen.margin > 0.0) {
    const EdgeRoom axes = room_of_axes(scale);
    edges.below += axes.below;
    edges.left += axes.left;
  }
  return camera_within(edges, size.width, size.height, seen.box, seen.margin);
}

PictureLayout layout_of(const PictureSize& size, const Seen& seen, TitleBand title, const Canvas& canvas,
                        const FigureSource& source, const FigureRequest& request) {
  const double scale = request.shown.scale;
  const auto camera_with = [&](const LegendStrip& strip) {
    const auto pixels = [&](double length) { return static_cast<int>(std::ceil(scale * length)); };
    return camera_for(size, seen, request.marks.axes, scale,
                      {.above = title.pixels, .below = pixels(strip.below), .right = pixels(strip.right)});
  };
  LegendStrip strip;
  const auto entries = entries_in(canvas.scene, request, 0.0);
  const auto fonts = PaperFonts::read(find_assets({}));
  if (request.legend_beside && !request.legend_at && !entries.empty() && fonts)
    strip = strip_for_legend([&](const LegendStrip& tried) {
      const render::Camera camera = camera_with(tried);
      return LegendTrial{
          explain(request, source, seen_plane(camera, scale), title.drawing.height, entries, tried, *fonts).legend,
          size.width / scale, size.height / scale, camera.units_per_pixel()};
    });
  return {camera_with(strip), std::move(title), strip};
}

TitleBand title_of(const RenderRequest& request, const PictureSize& size, const ShownLayers& shown) {
  if (request.title.empty()) return {};
  const auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) {
    say("the title is left out: " + fonts.error().message());
    return {};
  }
  PictureTitle title = layout_title(request.title, size.width / shown.scale, size.height / shown.scale,
                                    measure_with(*fonts, shown.scale), shown.background);
  if (!title.complaint.empty()) say("the title: " + title.complaint);
  const int pixels = static_cast<int>(std::ceil(shown.scale * title.drawing.height));
  return {std::move(title.drawing), pixels};
}

Expected<render::Image> draw_pixels(Canvas& canvas, const PictureLayout& layout, const FigureSource& source,
                                    const FigureRequest& request) {
  const ShownLayers& shown = request.shown;
  const double units_per_px = layout.camera.units_per_pixel() * shown.scale;
  std::vector<render::LayerView> all = views_of(shown, typical_spacing(source.document) / units_per_px);
  all.insert(all.end(), request.marks_above.begin(), request.marks_above.end());
  const auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) say("annotations, numbers, legend, scale bar and axes are left out: " + fonts.error().message());
  add_texts(shown.descriptors, all, {source.document}, {layout.camera.visible(), units_per_px},
            fonts ? &fonts->plain : nullptr);
  auto image = draw_in_bands(canvas.device, canvas.scene, layout.camera, all,
                             {.background = shown.background, .content_scale = shown.scale});
  if (image && fonts) add_paper(*image, canvas.scene, layout, source, request, *fonts);
  return image;
}

Expected<std::string> encoded(const render::Image& image, std::string_view session) {
  const auto png = render::encode_png(image, render::kPngSmall, session);
  if (!png) return std::unexpected(png.error());
  return std::string(reinterpret_cast<const char*>(png->data()), png->size());
}

FigureRequest figure_request(const PictureRequest& picture, const RenderRequest& wanted) {
  FigureRequest request{.shown = picture.shown,
                        .part = Everything{},
                        .page = picture.page,
                        .pixels = {picture.size.width, picture.size.height},
                        .is_tight = picture.is_tight,
                        .keeps_letters = picture.page.has_value(),
                        .legend = legend_scope(wanted.with_legend, wanted.with_key),
                        .legend_at = wanted.legend_at,
                        .legend_beside = true,
                        .marks = wanted.marks,
                        .title = wanted.title,
                        .image = picture.image,
                        .rasterized = picture.rasterized,
                        .dots_per_inch = picture.dots_per_inch};
  if (picture.view) request.part = *picture.view;
  return request;
}

Expected<std::string> written(const PictureRequest& picture, DrawnFigure drawn, bool is_traced, std::string session) {
  drawn.figure.session = std::move(session);
  if (is_traced && !picture.format->has_images)
    say("the picture " + picture.image.file + " is left out: " + std::string(picture.format->name) +
        " files hold none");
  std::vector<std::string> said;
  for (const std::string& remark : drawn.remarks) {
    if (std::ranges::find(said, remark) != said.end()) continue;
    say(remark);
    said.push_back(remark);
  }
  auto bytes = figure::bytes_of(drawn.figure, *picture.format);
  if (std::string text = tex_warning(figure::shape_count(drawn.figure), picture.format->extension);
      bytes && !text.empty())
    say(text);
  if (bytes && bytes->size() > kLargeFigure) {
    std::string text = fmt::format("the figure has {:.0f} MB", 1e-6 * static_cast<double>(bytes->size()));
    if (const figure::FigureLayer* const layer = largest_layer(drawn.figure); layer && picture.format->has_images)
      text += fmt::format(", most of it perhaps the {} shapes of one layer: --rasterize {} makes it a picture",
                          figure::shape_count(*layer), layer->id);
    say(text);
  }
  return bytes;
}

}  // namespace mes::cli

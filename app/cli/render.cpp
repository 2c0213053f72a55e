// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina render`: a picture of layers without a display.
#include "render/egl_context.h"

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/picture.h"
#include "app/cli/picture_request.h"
#include "app/cli/progress.h"
#include "app/cli/requests.h"
#include "app/export/carried.h"
#include "app/export/figure.h"
#include "app/picture/legend.h"
#include "app/picture/scale_drawing.h"
#include "app/store/background_loader.h"
#include "app/store/color_maps.h"
#include "app/store/sample_shapes.h"
#include "core/draw/layer_descriptor.h"
#include "core/io/carried_session.h"
#include "render/gl_device.h"
#include "render/offscreen.h"
#include "render/png.h"
#include "render/scene.h"

namespace mes::cli {
namespace {

/// The picture to trace, given its place if it has none; nothing without one.
Expected<std::optional<render::Image>> read_traced(PictureRequest& picture, const Box2& samples) {
  if (picture.image.file.empty()) return std::nullopt;
  if (const auto fingerprint = fingerprint_of_file(picture.image.file))
    picture.sources.push_back({picture.image.file, *fingerprint});
  auto image = read_background(picture.image.file);
  if (!image) return std::unexpected(image.error());
  if (!(picture.image.width > 0.0))
    picture.image = placed_in(samples, picture.image.file, static_cast<double>(image->height) / image->width);
  return std::move(*image);
}

render::Camera camera_for(const PictureRequest& picture, const Box2& samples, const LayerMirror& mirror) {
  render::Camera camera;
  camera.set_viewport(picture.size.width, picture.size.height);
  if (picture.view) {
    camera.fit(*picture.view, 0.0);
  } else {
    camera.fit(fit_box(samples, mirror, picture.shown.layers),
               kFitMargin * std::min(picture.size.width, picture.size.height));
  }
  return camera;
}

/// Above everything else, once the picture is there.
void add_paper(render::Image& image, const render::Scene& scene, std::span<const render::LayerView> views,
               const render::Camera& camera, const ShownLayers& shown, const RenderRequest& request,
               const PlacedAnnotations& annotations) {
  const std::vector<LegendEntry> entries =
      legend_of(scene, views, legend_scope(request.with_legend, request.with_key));
  if (entries.empty() && request.marks.is_empty() && annotations.is_empty()) return;
  const auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return say("annotations, legend, scale bar and axes are left out: " + fonts.error().message());
  const AnnotationDrawing annotated = layout_annotations(annotations, seen_plane(camera, shown.scale),
                                                         measure_with(*fonts, shown.scale), shown.background);
  for (const std::string& complaint : annotated.complaints) say(complaint);
  paint(image, *fonts, annotated.drawing, {0.0, 0.0}, shown.scale);
  if (!request.marks.is_empty())
    paint(image, *fonts,
          layout_scale_marks(request.marks, seen_plane(camera, shown.scale), measure_with(*fonts, shown.scale),
                             shown.background),
          {0.0, 0.0}, shown.scale);
  if (!entries.empty())
    draw_legend(image, *fonts,
                layout_legend(entries, *fonts, image.width, image.height, shown.scale, shown.background),
                LegendPlace::emptiest_corner);
}

/// Draws in bands from the top when there is much to draw, so that a terminal sees it go on. Bands meet without a
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

/// What the picture carries; empty for nothing.
std::string session_of(const RenderRequest& request, const PictureRequest& picture, const LoadedFile& input,
                       const ComputationSettings& settings) {
  const bool can_carry = picture.format == nullptr || picture.format->carries_session;
  if (!request.with_source || !can_carry) return {};
  LayerConfiguration layers{.layers = {}, .image = picture.image};
  for (const LayerIndex layer : picture.shown.layers)
    layers.layers.push_back({std::string(layer_descriptors()[layer].id), true, picture.shown.styles[layer]});
  // A picture of a picture is called what that was.
  std::string title =
      input.session ? input.session->title : std::filesystem::path(request.source.file).filename().string();
  auto packed = packed_session(
      session_for_picture(std::move(title), input.data, std::move(layers), settings, picture.view.value_or(Box2{})));
  if (!packed) say("the picture carries no source: it would be too long");
  return std::move(packed).value_or("");
}

/// A picture in pixels, as the bytes of a PNG file.
Expected<std::string> draw_pixels(const PictureRequest& picture, render::Device& device, render::Scene& scene,
                                  const render::Camera& camera, const FigureSource& source,
                                  const RenderRequest& request, std::string_view session) {
  const std::vector<render::LayerView> views = views_of(picture.shown, camera.units_per_pixel(), source.samples);
  auto image = draw_in_bands(device, scene, camera, views,
                             {.background = picture.shown.background, .content_scale = picture.shown.scale});
  if (!image) return std::unexpected(image.error());
  add_paper(*image, scene, views, camera, picture.shown, request, source.annotations);
  const auto png = render::encode_png(*image, render::kPngSmall, session);
  if (!png) return std::unexpected(png.error());
  return std::string(reinterpret_cast<const char*>(png->data()), png->size());
}

/// The bytes of a vector format.
Expected<std::string> draw_vectors(const PictureRequest& picture, const FigureSource& source,
                                   const RenderRequest& wanted, std::string session) {
  FigureRequest request{.shown = picture.shown,
                        .part = Everything{},
                        .page = picture.page,
                        .pixels = {picture.size.width, picture.size.height},
                        .is_tight = picture.is_tight,
                        .legend = legend_scope(wanted.with_legend, wanted.with_key),
                        .marks = wanted.marks,
                        .image = picture.image,
                        .rasterized = picture.rasterized,
                        .dots_per_inch = picture.dots_per_inch};
  if (picture.view) request.part = *picture.view;
  auto drawn = draw_figure(request, source);
  if (!drawn) return std::unexpected(drawn.error());
  drawn->figure.session = std::move(session);
  if (source.traced != nullptr && !picture.format->has_images)
    say("the picture " + picture.image.file + " is left out: " + std::string(picture.format->name) +
        " files hold none");
  for (const std::string& remark : drawn->remarks) say(remark);
  auto bytes = picture.format->write(drawn->figure);
  if (bytes && bytes->size() > kLargeFigure) {
    std::string text = fmt::format("the figure has {:.0f} MB", 1e-6 * static_cast<double>(bytes->size()));
    if (const figure::FigureLayer* const layer = largest_layer(drawn->figure); layer && picture.format->has_images)
      text += fmt::format(", most of it perhaps the {} shapes of one layer: --rasterize {} makes it a picture",
                          figure::shape_count(*layer), layer->id);
    say(text);
  }
  return bytes;
}

/// What a picture in pixels is drawn with.
struct Canvas {
  render::EglContext context;
  render::GlDevice device;
  render::Scene scene{device};
  explicit Canvas(render::EglContext made) : context(std::move(made)) {}
};

}  // namespace

Expected<void> run_render(const RenderRequest& request, Interruption& interruption) {
  auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  LoadedColorMaps maps = load_color_maps(find_assets({}), user_color_map_folder());
  auto picture = understand(request, maps.maps, nullptr);
  if (!picture) return std::unexpected(picture.error());
  if (auto good = check_output(request.output); !good) return good;
  if (std::ranges::any_of(picture->shown.styles, [](const LayerStyle& style) { return !style.color_map.empty(); }))
    for (const Error& problem : maps.problems) say("a colour map is left out: " + problem.message());
  const auto input = read_input(request.source.file, request.source.from);
  if (!input) return std::unexpected(input.error());
  if (const Session* const session = input->session.get()) {
    picture = understand(request, maps.maps, session);
    if (!picture) return std::unexpected(picture.error());
    if (request.source.precision.empty() && request.source.settings.empty()) *settings = session->settings;
  }

  std::optional<Canvas> canvas;
  if (picture->format == nullptr) {
    auto context = render::EglContext::create();
    if (!context) return std::unexpected(context.error());
    canvas.emplace(std::move(*context));
    canvas->scene.set_color_maps(maps.maps);
  }
  Box2 samples;
  for (const Vec2 position : input->data.positions) samples.add(position);
  const auto traced = read_traced(*picture, samples);
  if (!traced) return std::unexpected(traced.error());
  if (canvas && *traced) {
    canvas->scene.set_picture(find_layer("image"), **traced);
    canvas->scene.place_picture({picture->image.center, picture->image.width});
  }
  LayerMirror mirror;
  const auto result = compute_with_progress(
      input->data, {.layers = picture->shown.layers, .settings = *settings, .on_patch = [&](const FramePatch& patch) {
                      if (canvas) canvas->scene.apply(patch);
                      mirror.apply(patch);
                    }});
  if (!result) return std::unexpected(result.error());

  const Box2 bounds = result->document.bounding_box();
  std::string session = session_of(request, *picture, *input, *settings);
  const FigureSource source{.mirror = mirror,
                            .samples = input->data.positions,
                            .bounds = bounds,
                            .maps = maps.maps,
                            .traced = *traced ? &**traced : nullptr,
                            .annotations = request.with_annotations ? place(result->document) : PlacedAnnotations{}};
  const auto bytes = canvas ? draw_pixels(*picture, canvas->device, canvas->scene,
                                          camera_for(*picture, bounds, mirror), source, request, session)
                            : draw_vectors(*picture, source, request, std::move(session));
  if (!bytes) return std::unexpected(bytes.error());
  std::vector<SourceFile> sources = std::move(picture->sources);
  sources.insert(sources.end(), input->sources.begin(), input->sources.end());
  return write_output(request.output, *bytes, interruption, {std::move(sources), request.force});
}

}  // namespace mes::cli

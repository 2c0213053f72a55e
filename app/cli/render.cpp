// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina render`: a picture of layers without a display.
#include "render/egl_context.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/cli/bundle_request.h"
#include "app/cli/computation.h"
#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/picture.h"
#include "app/cli/progress.h"
#include "app/cli/requests.h"
#include "app/cli/style_request.h"
#include "app/picture/canvas_look.h"
#include "app/picture/legend.h"
#include "app/store/background_loader.h"
#include "app/store/color_maps.h"
#include "app/store/sample_shapes.h"
#include "core/base/lower_case.h"
#include "core/draw/layer_descriptor.h"
#include "core/io/text_numbers.h"
#include "render/gl_device.h"
#include "render/offscreen.h"
#include "render/png.h"
#include "render/scene.h"

namespace mes::cli {
namespace {

/// The request, understood.
struct Picture {
  std::vector<LayerIndex> layers;  // bottom first
  std::vector<LayerStyle> styles;  // of all layers
  PictureSize size;
  std::optional<Box2> view;
  std::optional<Rgb> background;
  BackgroundImage image;
  double scale = 1.0;
  std::vector<SourceFile> sources;  // bundle and image
};

Expected<void> check_picture_name(const std::string& file) {
  if (is_standard_output(file)) {
    if (::isatty(STDOUT_FILENO) != 0) return usage_error("a picture cannot be printed on a terminal; name a file");
    return {};
  }
  const std::string extension = lower_case_extension(file);
  if (extension == ".png") return {};
  constexpr std::array<std::string_view, 3> kLater{".svg", ".pdf", ".ps"};
  if (std::ranges::find(kLater, extension) != kLater.end())
    return usage_error("pictures in " + extension + " are not available in this build; .png is");
  return usage_error("the name of the picture must end in .png, not " + in_quotes(extension));
}

/// Layers and styles of a bundle; unknown layers in it are reported.
Expected<void> take_bundle(const std::string& name_or_file, Picture& picture) {
  const auto bundle = find_bundle(name_or_file, picture.sources);
  if (!bundle) return std::unexpected(bundle.error());
  std::size_t unknown = 0;
  for (const LayerConfiguration::Entry& entry : bundle->layers.layers) {
    const LayerIndex layer = find_layer(entry.layer);
    if (layer == kNoLayer) {
      ++unknown;
      continue;
    }
    picture.styles[layer] = entry.style;
    if (entry.visible && std::ranges::find(picture.layers, layer) == picture.layers.end())
      picture.layers.push_back(layer);
  }
  std::error_code error;
  if (const BackgroundImage& image = bundle->layers.image; !image.file.empty()) {
    if (std::filesystem::exists(image.file, error))
      picture.image = image;
    else
      say(fmt::format("bundle {}: the picture {} is not there", in_quotes(bundle->name), image.file));
  }
  if (unknown != 0)
    say(fmt::format("bundle {}: {} {} not available here", in_quotes(bundle->name), unknown,
                    unknown == 1 ? "layer is" : "layers are"));
  return {};
}

Expected<void> take_layers(const std::string& ids, Picture& picture) {
  auto layers = select_layers(ids);
  if (!layers) return std::unexpected(layers.error());
  picture.layers = std::move(*layers);
  // The stacking order is the registry's, whatever the order of the words.
  std::ranges::sort(picture.layers);
  return {};
}

Expected<Picture> understand(const RenderRequest& request, std::span<const render::ColorMap> maps) {
  Picture picture;
  for (const LayerDescriptor& layer : layer_descriptors()) picture.styles.push_back(layer.style);
  const auto taken =
      request.bundle.empty() ? take_layers(request.layers, picture) : take_bundle(request.bundle, picture);
  if (!taken) return std::unexpected(taken.error());
  if (!request.image.empty()) {
    picture.image = parse_image(request.image);
    const LayerIndex layer = find_layer("image");
    // It belongs below everything, wherever a bundle has it.
    std::erase(picture.layers, layer);
    picture.layers.insert(picture.layers.begin(), layer);
  }
  std::vector<std::string> map_names;
  for (const render::ColorMap& map : maps) map_names.push_back(map.name);
  auto styles = changed_styles(std::move(picture.styles), request.styles, picture.layers, map_names);
  if (!styles) return std::unexpected(styles.error());
  picture.styles = std::move(*styles);
  const auto size = parse_size(request.size);
  if (!size) return std::unexpected(size.error());
  picture.size = *size;
  const auto view = parse_view(request.view);
  if (!view) return std::unexpected(view.error());
  picture.view = *view;
  const auto background = parse_background(request.background);
  if (!background) return std::unexpected(background.error());
  picture.background = *background;
  constexpr double kLeastScale = 0.01;
  constexpr double kMostScale = 100.0;
  const auto scale = parse_number(request.scale);
  if (!scale || *scale < kLeastScale || *scale > kMostScale)
    return usage_error("--scale expects a number from 0.01 to 100, not " + in_quotes(request.scale));
  picture.scale = *scale;
  if (auto good = check_picture_name(request.output); !good) return std::unexpected(good.error());
  return picture;
}

/// The picture to trace: in its place, or the one it is given.
Expected<void> add_image(Picture& picture, const Box2& samples, render::Scene& scene) {
  if (picture.image.file.empty()) return {};
  if (const auto fingerprint = fingerprint_of_file(picture.image.file))
    picture.sources.push_back({picture.image.file, *fingerprint});
  const auto image = read_background(picture.image.file);
  if (!image) return std::unexpected(image.error());
  if (!(picture.image.width > 0.0))
    picture.image = placed_in(samples, picture.image.file, static_cast<double>(image->height) / image->width);
  scene.set_picture(find_layer("image"), *image);
  scene.place_picture({picture.image.center, picture.image.width});
  return {};
}

render::Camera camera_for(const Picture& picture, const Box2& samples, const LayerMirror& mirror) {
  render::Camera camera;
  camera.set_viewport(picture.size.width, picture.size.height);
  constexpr double kMargin = 0.05;
  if (picture.view) {
    camera.fit(*picture.view, 0.0);
  } else {
    camera.fit(fit_box(samples, mirror, picture.layers), kMargin * std::min(picture.size.width, picture.size.height));
  }
  return camera;
}

/// Styles as they are, but samples that stand closer than their dots are wide get smaller dots, so that they are seen
/// one by one where pixels allow, and the curve under them.
std::vector<render::LayerView> views_of(const Picture& picture, const render::Camera& camera,
                                        const std::vector<Vec2>& samples) {
  constexpr double kShareOfSpacing = 0.7;
  constexpr double kSmallestDot = 1.5;
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : picture.layers) {
    LayerStyle style = picture.styles[layer];
    const bool is_chosen = style.point_size_px != layer_descriptors()[layer].style.point_size_px;
    if (!is_chosen && layer_descriptors()[layer].id == "points" && samples.size() > 1) {
      const double spacing_px = typical_spacing(samples) / camera.units_per_pixel() / picture.scale;
      const double limit = std::max(kSmallestDot, kShareOfSpacing * spacing_px);
      style.point_size_px = std::min(style.point_size_px, limit);
    }
    views.push_back({layer, drawn_on(style, picture.background)});
  }
  return views;
}

/// Above everything else, once the picture is there.
void add_legend(render::Image& image, const render::Scene& scene, std::span<const render::LayerView> views,
                double scale, const std::optional<Rgb>& background) {
  const std::vector<LegendEntry> entries = legend_of(scene, views);
  if (entries.empty()) return;
  const auto fonts = LegendFonts::read(find_assets({}));
  if (fonts)
    draw_legend(image, *fonts, layout_legend(entries, *fonts, image.width, image.height, scale, background),
                LegendPlace::emptiest_corner);
  else
    say("the legend is left out: " + fonts.error().message());
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

}  // namespace

Expected<void> run_render(const RenderRequest& request, Interruption& interruption) {
  const auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  LoadedColorMaps maps = load_color_maps(find_assets({}), user_color_map_folder());
  auto picture = understand(request, maps.maps);
  if (!picture) return std::unexpected(picture.error());
  if (auto good = check_output(request.output); !good) return good;
  if (std::ranges::any_of(picture->styles, [](const LayerStyle& style) { return !style.color_map.empty(); }))
    for (const Error& problem : maps.problems) say("a colour map is left out: " + problem.message());
  const auto input = read_input(request.source.file, request.source.from);
  if (!input) return std::unexpected(input.error());

  const auto context = render::EglContext::create();
  if (!context) return std::unexpected(context.error());
  render::GlDevice device;
  render::Scene scene(device);
  scene.set_color_maps(std::move(maps.maps));
  Box2 samples;
  for (const Vec2 position : input->data.positions) samples.add(position);
  if (auto good = add_image(*picture, samples, scene); !good) return good;
  LayerMirror mirror;
  const auto result = run_computation(
      input->data, {.layers = picture->layers, .settings = *settings, .on_patch = [&](const FramePatch& patch) {
                      scene.apply(patch);
                      mirror.apply(patch);
                    }});
  if (!result) return std::unexpected(result.error());

  const render::Camera camera = camera_for(*picture, result->document.bounding_box(), mirror);
  const std::vector<render::LayerView> views = views_of(*picture, camera, input->data.positions);
  auto image = draw_in_bands(device, scene, camera, views,
                             {.background = picture->background, .content_scale = picture->scale});
  if (!image) return std::unexpected(image.error());
  if (request.with_legend) add_legend(*image, scene, views, picture->scale, picture->background);
  const auto png = render::encode_png(*image, render::kPngSmall);
  if (!png) return std::unexpected(png.error());
  std::vector<SourceFile> sources = std::move(picture->sources);
  sources.insert(sources.end(), input->sources.begin(), input->sources.end());
  return write_output(request.output, {reinterpret_cast<const char*>(png->data()), png->size()}, interruption,
                      {std::move(sources), request.force});
}

}  // namespace mes::cli

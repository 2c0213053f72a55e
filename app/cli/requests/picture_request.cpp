// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/picture_request.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/bundle_request.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/cli/requests/style_request.h"
#include "app/settings/figure_settings.h"
#include "core/base/lower_case.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"
#include "render/figure/figure.h"

namespace mes::cli {
namespace {

/// The possible file extensions of a picture: ".png, .svg, .pdf".
std::vector<std::string_view> extensions() {
  std::vector<std::string_view> out{kPixelExtension};
  for (const figure::Format& format : figure::formats()) out.push_back(format.extension);
  return out;
}

Expected<const figure::Format*> format_named(const std::string& extension, const std::string& refusal) {
  if (extension == kPixelExtension) return nullptr;
  if (const figure::Format* const format = figure::format_for(extension)) return format;
  return usage_error(refusal);
}

Expected<const figure::Format*> format_of(const RenderRequest& request) {
  const std::string& file = request.output;
  if (is_standard_output(file) && ::isatty(STDOUT_FILENO) != 0)
    return usage_error("a picture cannot be printed on a terminal; name a file");
  if (!request.format.empty())
    return format_named('.' + lower_case(request.format),
                        "--to expects " + one_of(picture_formats()) + ", not " + in_quotes(request.format));
  if (is_standard_output(file)) return nullptr;
  const std::string extension = lower_case_extension(file);
  return format_named(extension, "the name of the picture must end in " + one_of(extensions()) + ", not " +
                                     in_quotes(extension) + "; or name its format with --to");
}

/// Rejects options that are only for figures, or only for pixels.
Expected<void> check_kind(const RenderRequest& request, const figure::Format* format) {
  if (format != nullptr) return {};
  if (!request.figure_size.empty()) return usage_error("--figure-size is for vector formats; a .png has --size");
  if (request.bounds != kBoundsOfView) return usage_error("--bounds is for vector formats");
  if (!request.rasterized.empty()) return usage_error("--rasterize is for vector formats");
  return {};
}

/// Takes the layers that become pictures in a vector format.
Expected<void> take_rasterized(const Registry& registry, const RenderRequest& request, PictureRequest& picture) {
  constexpr double kLeast = 10.0;
  constexpr double kMost = 2400.0;
  const auto dpi = parse_number(request.dpi);
  if (!dpi || *dpi < kLeast || *dpi > kMost)
    return usage_error("--dpi expects a number from 10 to 2400, not " + in_quotes(request.dpi));
  picture.dots_per_inch = *dpi;
  if (request.rasterized.empty()) return {};
  if (!picture.format->has_images)
    return usage_error("--rasterize: " + std::string(picture.format->name) + " files hold no pictures");
  const auto layers = select_layers(registry, request.rasterized);
  if (!layers) return std::unexpected(layers.error());
  for (const LayerIndex layer : *layers) picture.rasterized.emplace_back(registry.layers()[layer].id);
  return {};
}

/// Takes layers and styles; reports unknown layers, with `what` as the name of their source.
void take_configuration(const Registry& registry, const LayerConfiguration& configuration, const std::string& what,
                        PictureRequest& picture) {
  std::size_t unknown = 0;
  for (const LayerConfiguration::Entry& entry : configuration.layers) {
    const LayerIndex layer = registry.find_layer(entry.layer);
    if (layer == kNoLayer) {
      ++unknown;
      continue;
    }
    picture.shown.styles[layer] = entry.style;
    if (entry.visible && std::ranges::find(picture.shown.layers, layer) == picture.shown.layers.end())
      picture.shown.layers.push_back(layer);
  }
  std::error_code error;
  if (const BackgroundImage& image = configuration.image; !image.file.empty()) {
    if (std::filesystem::exists(image.file, error))
      picture.image = image;
    else
      say(what + ": the picture " + image.file + " is not there");
  }
  say_unknown_layers(unknown, what);
}

Expected<void> take_bundle(const Registry& registry, const std::string& name_or_file, PictureRequest& picture) {
  const auto bundle = find_bundle(registry, name_or_file, picture.sources);
  if (!bundle) return std::unexpected(bundle.error());
  take_configuration(registry, bundle->layers, "bundle " + in_quotes(bundle->name), picture);
  return {};
}

Expected<void> take_layers(const Registry& registry, const std::string& ids, PictureRequest& picture) {
  auto layers = select_layers(registry, ids);
  if (!layers) return std::unexpected(layers.error());
  // The stacking order is that of the registry, whatever the order of the words.
  std::ranges::sort(*layers);
  picture.shown.layers = main_layers(*layers);
  return {};
}

}  // namespace

std::vector<std::string_view> picture_formats() {
  std::vector<std::string_view> out = extensions();
  for (std::string_view& name : out) name.remove_prefix(1);
  return out;
}

Expected<PictureRequest> understand(const Registry& registry, const RenderRequest& request,
                                    std::span<const render::ColorMap> maps, const Session* session) {
  PictureRequest picture;
  picture.shown.descriptors = registry.layers();
  for (const LayerDescriptor& layer : registry.layers()) picture.shown.styles.push_back(layer.style);
  if (session != nullptr && request.layers.empty() && request.bundle.empty() && !session->layers.layers.empty()) {
    take_configuration(registry, session->layers, "the session", picture);
  } else {
    const auto taken = request.bundle.empty() ? take_layers(registry, request.layers, picture)
                                              : take_bundle(registry, request.bundle, picture);
    if (!taken) return std::unexpected(taken.error());
  }
  if (!request.image.empty()) {
    picture.image = parse_image(request.image);
    const LayerIndex layer = registry.find_layer("image");
    if (layer == kNoLayer) return usage_error("--image: there is no layer for pictures");
    // The picture to trace is below everything, whatever its position in a bundle.
    std::erase(picture.shown.layers, layer);
    picture.shown.layers.insert(picture.shown.layers.begin(), layer);
  }
  std::vector<std::string> map_names;
  for (const render::ColorMap& map : maps) map_names.push_back(map.name);
  if (!request.figure_size.empty()) {
    const auto page = parse_page_size(request.figure_size);
    if (!page) return usage_error("--figure-size " + page.error().text);
    picture.page = *page;
  }
  const double on_paper =
      picture.page ? scale_for_letters(picture.page->lettering * FigureSettings().letters_pt) : 1.0;
  auto styles = changed_styles(registry, std::move(picture.shown.styles), request.styles, picture.shown.layers,
                               map_names, on_paper);
  if (!styles) return std::unexpected(styles.error());
  picture.shown.styles = std::move(*styles);
  const auto format = format_of(request);
  if (!format) return std::unexpected(format.error());
  picture.format = *format;
  if (auto good = check_kind(request, picture.format); !good) return std::unexpected(good.error());
  const auto size = parse_size(request.size);
  if (!size) return std::unexpected(size.error());
  picture.size = *size;
  if (request.bounds != kBoundsOfView && request.bounds != kBoundsOfInk)
    return usage_error("--bounds expects view or tight, not " + in_quotes(request.bounds));
  picture.is_tight = request.bounds == kBoundsOfInk;
  if (auto good = take_rasterized(registry, request, picture); !good) return std::unexpected(good.error());
  if (!request.view.empty()) {
    const auto view = parse_view(request.view);
    if (!view) return std::unexpected(view.error());
    picture.view = *view;
  } else if (session != nullptr && !session->view.is_empty()) {
    picture.view = session->view;
  }
  const auto background = parse_background(request.background);
  if (!background) return std::unexpected(background.error());
  picture.shown.background = *background;
  constexpr double kLeastScale = 0.01;
  constexpr double kMostScale = 100.0;
  const auto scale = parse_number(request.scale);
  if (!scale || *scale < kLeastScale || *scale > kMostScale)
    return usage_error("--scale expects a number from 0.01 to 100, not " + in_quotes(request.scale));
  picture.shown.scale = *scale * on_paper;
  if (picture.page)
    picture.shown.least_line_px = FigureSettings().least_line_pt / (figure::kPointsPerPixel * picture.shown.scale);
  return picture;
}

}  // namespace mes::cli

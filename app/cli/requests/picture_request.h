// SPDX-License-Identifier: GPL-3.0-or-later
// The interpreted request of `mesecina render`: the common part of a picture in pixels and a figure.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/cli/requests/picture.h"
#include "app/cli/requests/requests.h"
#include "app/export/page_size.h"
#include "app/export/shown_layers.h"
#include "core/base/error.h"
#include "core/document/settings/layer_configuration.h"
#include "core/io/files/file_fingerprint.h"
#include "core/io/session/session.h"
#include "render/figure/writers.h"
#include "render/instances/colormap.h"

namespace mes {
class Registry;
}

namespace mes::cli {

inline constexpr std::string_view kPixelExtension = ".png";
inline constexpr std::string_view kBoundsOfView = "view";
inline constexpr std::string_view kBoundsOfInk = "tight";

struct PictureRequest {
  ShownLayers shown;
  const figure::Format* format = nullptr;  // null: pixels
  PictureSize size;
  std::optional<PageSize> page;  // for a figure; nothing: `size` in pixels of 1/96 inch
  bool is_tight = false;         // a figure is cut to its drawing
  std::optional<Box2> view;
  BackgroundImage image;
  std::vector<std::string> rasterized;  // ids of layers
  double dots_per_inch = 300.0;         // for these layers
  std::vector<SourceFile> sources;      // bundle and image
};

/// Interprets the request. Layers, their styles and the view are those of `session` (null: no session) if the request
/// names none. Error: `usage`, or `bad_input` for a bundle that cannot be read.
Expected<PictureRequest> understand(const Registry& registry, const RenderRequest& request,
                                    std::span<const render::ColorMap> maps, const Session* session);

/// The formats of `render`: the possible file extensions of pictures, without the dot.
std::vector<std::string_view> picture_formats();

}  // namespace mes::cli

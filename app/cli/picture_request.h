// SPDX-License-Identifier: GPL-3.0-or-later
// The request of `mesecina render`, understood: what a picture in pixels and a figure have in common.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/cli/page_size.h"
#include "app/cli/picture.h"
#include "app/cli/requests.h"
#include "core/base/error.h"
#include "core/document/layer_configuration.h"
#include "core/draw/layer_style.h"
#include "core/io/file_fingerprint.h"
#include "render/colormap.h"
#include "render/figure/writers.h"
#include "render/scene.h"

namespace mes::cli {

inline constexpr std::string_view kPixelExtension = ".png";
inline constexpr std::string_view kBoundsOfView = "view";
inline constexpr std::string_view kBoundsOfInk = "tight";
/// Between what "fit" shows and the edge, as a part of the shorter side.
inline constexpr double kFitMargin = 0.05;

struct PictureRequest {
  std::vector<LayerIndex> layers;          // bottom first
  std::vector<LayerStyle> styles;          // of all layers
  const figure::Format* format = nullptr;  // null: pixels
  PictureSize size;
  std::optional<PageSize> page;  // of a figure; none: `size` in pixels of 1/96 inch
  bool is_tight = false;         // a figure is cut to what is drawn
  std::optional<Box2> view;
  std::optional<Rgb> background;
  BackgroundImage image;
  double scale = 1.0;
  std::vector<SourceFile> sources;  // bundle and image
};

/// Error: `usage`, or `bad_input` for a bundle that cannot be read.
Expected<PictureRequest> understand(const RenderRequest& request, std::span<const render::ColorMap> maps);

/// The layers bottom first, with styles as they are; but samples that stand closer than their dots are wide get smaller
/// dots, so that they are seen one by one where the size allows, and the curve under them. `units_per_pixel` is in units
/// of the document per pixel of the picture.
std::vector<render::LayerView> views_of(const PictureRequest& picture, double units_per_pixel,
                                        const std::vector<Vec2>& samples);

}  // namespace mes::cli

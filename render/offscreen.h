// SPDX-License-Identifier: GPL-3.0-or-later
// A scene drawn into a picture of any size.
//
// What it guarantees:
//  1. The picture is the one a window of that size would show, whatever the limits of the graphics hardware: larger
//     pictures are drawn in tiles that meet without a seam.
//  2. A size that makes no sense or does not fit in memory is an error, not a crash.
//
// Smallest use:
//     auto image = draw_image(device, scene, camera, views, {.background = Rgb{255, 255, 255}});
//     auto png = encode_png(*image);
//
// Cost: drawing, plus one read-back of 4 bytes a pixel. Threads: the one that owns the context.
#pragma once

#include <optional>
#include <span>

#include "core/base/color.h"
#include "core/base/error.h"
#include "render/camera.h"
#include "render/device.h"
#include "render/image.h"
#include "render/scene.h"

namespace mes::render {

struct ImageOptions {
  std::optional<Rgb> background;  ///< none: transparent
  double content_scale = 1.0;     ///< pixels per logical pixel of styles
  bool overlays = false;
  int samples = 1;     ///< multisampling on top of analytic edges; 1 is enough
  int tile_px = 4096;  ///< largest tile; the device's limit caps it
};

/// Draws the camera's whole viewport.
Expected<Image> draw_image(Device& device, Scene& scene, const Camera& camera, std::span<const LayerView> views,
                           const ImageOptions& options);

/// Reads what a target shows now, for snapshots of the window; `area` in pixels from the lower left corner.
Image read_image(Device& device, FramebufferId source, const PixelRect& area);

}  // namespace mes::render

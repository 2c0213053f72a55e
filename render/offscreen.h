// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a scene into a picture of any size.
//
// Guarantees:
//  1. The picture is that of a window of its size, whatever the limits of the graphics hardware: large pictures are
//     drawn in seamless tiles.
//  2. A size that is too large for the format or for memory is an error, not a crash.
//
// Smallest use:
//     auto image = draw_image(device, scene, camera, views, {.background = Rgb{255, 255, 255}});
//     auto png = encode_png(*image);
//
// Cost: drawing, and one read-back of 4 bytes a pixel. Threads: the one that owns the context.
#pragma once

#include <optional>
#include <span>

#include "core/base/color.h"
#include "core/base/error.h"
#include "render/camera.h"
#include "render/device/device.h"
#include "render/image/image.h"
#include "render/scene.h"

namespace mes::render {

struct ImageOptions {
  std::optional<Rgb> background;  ///< none: transparent
  double content_scale = 1.0;     ///< pixels per logical pixel of styles
  bool overlays = false;
  int samples = 1;     ///< multisampling; 1: off, and enough, because edges are analytic
  int tile_px = 4096;  ///< largest side of a tile, at most the device's limit
};

/// Draws the camera's whole viewport. Errors: `usage` for too many pixels, `out_of_memory`.
Expected<Image> draw_image(Device& device, Scene& scene, const Camera& camera, std::span<const LayerView> views,
                           const ImageOptions& options);

/// Reads the current contents of a target, for snapshots of the window.
Image read_image(Device& device, FramebufferId source, const PixelRect& area);

}  // namespace mes::render

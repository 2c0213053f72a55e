// SPDX-License-Identifier: GPL-3.0-or-later
// A device without a window, a scene on it, and short ways to fill and look at it.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/draw/patch.h"
#include "render/camera.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/image/image.h"
#include "render/offscreen.h"
#include "render/scene.h"

namespace mes::test {

inline constexpr Rgb kWhite{255, 255, 255};

/// A patch that sets all instances of one kind; `coordinates` without scalars, of a layer that has none unless given.
FramePatch instances(LayerIndex layer, PrimitiveKind kind, const std::vector<double>& coordinates,
                     const DrawingFrame& frame = {}, const std::vector<double>& scalars = {});
/// A patch that overwrites some instances.
FramePatch changes(LayerIndex layer, PrimitiveKind kind, std::uint32_t count, const std::vector<std::uint32_t>& index,
                   const std::vector<double>& coordinates, const DrawingFrame& frame = {},
                   const std::vector<double>& scalars = {});

/// One world unit is one pixel and the world's origin the lower left corner.
render::Camera pixel_camera(int width, int height);

class Drawing {
 public:
  explicit Drawing(const render::GlDeviceOptions& options = {});

  void set(LayerIndex layer, PrimitiveKind kind, const std::vector<double>& coordinates,
           const DrawingFrame& frame = {}, const std::vector<double>& scalars = {});
  /// Draws all of `views` on white, or on nothing.
  render::Image draw(const render::Camera& camera, const std::vector<render::LayerView>& views,
                     const render::ImageOptions& options = {.background = kWhite});

  render::GlDevice& device() { return *device_; }
  render::Scene& scene() { return *scene_; }

 private:
  render::EglContext context_;
  std::unique_ptr<render::GlDevice> device_;
  std::unique_ptr<render::Scene> scene_;
};

/// How much of pixel (x, y from the top) a black drawing on white covers, in [0, 1].
double cover(const render::Image& image, int x, int y);
/// The same, summed over all pixels.
double covered_area(const render::Image& image);
/// Middle of what is covered, in pixels from the upper left corner.
Vec2 covered_center(const render::Image& image);

}  // namespace mes::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen.h"

#include <fmt/core.h>
#include <algorithm>
#include <new>
#include <string>

namespace mes::render {
namespace {

// Writers of picture formats cannot handle more bytes.
constexpr std::size_t kMaxPixels = std::size_t{1} << 29U;

class OwnedFramebuffer {
 public:
  OwnedFramebuffer(Device& device, const FramebufferSpec& spec)
      : device_(device), id_(device.create_framebuffer(spec)) {}
  ~OwnedFramebuffer() { device_.destroy_framebuffer(id_); }
  OwnedFramebuffer(const OwnedFramebuffer&) = delete;
  OwnedFramebuffer& operator=(const OwnedFramebuffer&) = delete;
  FramebufferId id() const { return id_; }

 private:
  Device& device_;
  FramebufferId id_;
};

/// Copies a tile, reverses the order of its rows and divides by alpha.
void place_tile(std::span<const std::uint8_t> tile, int tile_width, int tile_height, Image& image, int left,
                int top) {
  for (int y = 0; y < tile_height; ++y) {
    const auto row = static_cast<std::size_t>(tile_height - 1 - y) * static_cast<std::size_t>(tile_width) * 4;
    const std::uint8_t* from = &tile[row];
    std::uint8_t* to = &image.rgba[image.offset(left, top + y)];
    for (int x = 0; x < tile_width; ++x, from += 4, to += 4) {
      const unsigned alpha = from[3];
      for (int channel = 0; channel < 3; ++channel) {
        const unsigned value = from[channel];
        to[channel] = static_cast<std::uint8_t>(
            alpha == 255 ? value : (alpha == 0 ? 0 : std::min(255U, (value * 255U + alpha / 2) / alpha)));
      }
      to[3] = static_cast<std::uint8_t>(alpha);
    }
  }
}

}  // namespace

Expected<Image> draw_image(Device& device, Scene& scene, const Camera& camera, std::span<const LayerView> views,
                           const ImageOptions& options) {
  const int width = camera.width();
  const int height = camera.height();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::string size = fmt::format("{}x{}", width, height);
  if (pixels > kMaxPixels) {
    return std::unexpected(Error{.code = ErrorCode::usage, .text = "a picture of " + size + " pixels is too large"});
  }
  try {
    Image image{.width = width, .height = height, .rgba = std::vector<std::uint8_t>(4 * pixels)};
    const int tile = std::clamp(options.tile_px, 16, device.max_framebuffer_size());
    const OwnedFramebuffer target(device, {.width = std::min(width, tile),
                                           .height = std::min(height, tile),
                                           .format = TargetFormat::color,
                                           .samples = options.samples});
    std::vector<std::uint8_t> bytes;
    for (int top = 0; top < height; top += tile) {
      for (int left = 0; left < width; left += tile) {
        const PixelRect area{0, 0, std::min(tile, width - left), std::min(tile, height - top)};
        device.clear(target.id(), area, clear_color(options.background));
        scene.draw(camera.part(left, top, area.width, area.height), views,
                   {.content_scale = options.content_scale, .target = target.id(), .overlays = options.overlays});
        bytes.resize(std::size_t{4} * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
        device.read_pixels(target.id(), area, bytes);
        place_tile(bytes, area.width, area.height, image, left, top);
      }
    }
    return image;
  } catch (const std::bad_alloc&) {
    return std::unexpected(
        Error{.code = ErrorCode::out_of_memory, .text = "not enough memory for a picture of " + size + " pixels"});
  }
}

Image to_image(const RawImage& raw) {
  Image image{.width = raw.width, .height = raw.height, .rgba = std::vector<std::uint8_t>(raw.rgba.size())};
  place_tile(raw.rgba, raw.width, raw.height, image, 0, 0);
  return image;
}

Image read_image(Device& device, FramebufferId source, const PixelRect& area) {
  const std::size_t pixels = static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
  RawImage raw{.width = area.width, .height = area.height, .rgba = std::vector<std::uint8_t>(4 * pixels)};
  device.read_pixels(source, area, raw.rgba);
  return to_image(raw);
}

}  // namespace mes::render

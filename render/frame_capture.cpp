// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_capture.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <utility>

#include "core/base/assert.h"

namespace mes::render {
namespace {

// Copies a tile into a picture; both have the bottom row first.
void place(const RawImage& tile, const PixelRect& at, RawImage& picture) {
  const std::size_t row = 4 * static_cast<std::size_t>(at.width);
  for (int y = 0; y < at.height; ++y) {
    const auto to = 4 * (static_cast<std::size_t>(at.bottom + y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(at.left));
    std::memcpy(&picture.rgba[to], &tile.rgba[static_cast<std::size_t>(y) * row], row);
  }
}

std::unexpected<Error> no_memory_for(int width, int height) {
  return std::unexpected(Error{.code = ErrorCode::out_of_memory,
                               .text = fmt::format("not enough memory for a frame of {}x{} pixels", width, height)});
}

}  // namespace

FrameCapture::~FrameCapture() {
  for (const Target& target : targets_)
    if (target.id != FramebufferId{}) device_.destroy_framebuffer(target.id);
}

FramebufferId FrameCapture::target(std::size_t level, int width, int height) {
  Target& out = targets_[level];
  if (out.id != FramebufferId{} && out.width == width && out.height == height) return out.id;
  if (out.id != FramebufferId{}) device_.destroy_framebuffer(std::exchange(out.id, {}));
  out.id = device_.create_framebuffer({.width = width, .height = height, .format = TargetFormat::color});
  out.width = width;
  out.height = height;
  return out.id;
}

Expected<void> FrameCapture::draw(Scene& scene, const Camera& camera, std::span<const LayerView> views,
                                  const CaptureOptions& options) {
  const int factor = options.supersampling;
  MES_ASSERT(factor == 1 || factor == 2 || factor == 4);
  const int width = camera.width();
  const int height = camera.height();
  const int tile = std::max(16, std::min(options.tile_px, device_.max_framebuffer_size()) / factor);
  Camera large = camera;
  large.set_viewport(factor * width, factor * height);
  large.look_at(camera.center(), camera.units_per_pixel() / factor);
  const std::size_t before = wanted_.size();
  try {
    const int tile_width = std::min(width, tile);
    const int tile_height = std::min(height, tile);
    const std::size_t levels = factor == 1 ? 1 : factor == 2 ? 2 : 3;
    std::array<FramebufferId, 3> chain{};
    for (std::size_t level = 0, size = static_cast<std::size_t>(factor); level < levels; ++level, size /= 2)
      chain[level] = target(level, static_cast<int>(size) * tile_width, static_cast<int>(size) * tile_height);
    Wanted wanted{width, height, {}, {}};
    const bool is_one = tile_width == width && tile_height == height;
    if (!is_one) {
      wanted.picture = {
          width, height,
          std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    }
    wanted_.push_back(std::move(wanted));
    for (int top = 0; top < height; top += tile) {
      for (int left = 0; left < width; left += tile) {
        const int part_width = std::min(tile, width - left);
        const int part_height = std::min(tile, height - top);
        PixelRect drawn{0, 0, factor * part_width, factor * part_height};
        device_.clear(chain[0], drawn, clear_color(options.background));
        scene.draw(
            large.part(factor * left, factor * top, drawn.width, drawn.height), views,
            {.content_scale = factor * options.content_scale, .target = chain[0], .overlays = options.overlays});
        for (std::size_t level = 1; level < levels; ++level) {
          const PixelRect half{0, 0, drawn.width / 2, drawn.height / 2};
          device_.shrink(chain[level], half, chain[level - 1], drawn);
          drawn = half;
        }
        ask_for_tile(chain[levels - 1], drawn, {left, height - top - part_height, part_width, part_height});
      }
    }
    return {};
  } catch (const std::bad_alloc&) {
    if (wanted_.size() != before) wanted_.back().is_given_up = true;
    return no_memory_for(width, height);
  }
}

// There are as many tiles as pictures that the readback will return.
void FrameCapture::ask_for_tile(FramebufferId source, const PixelRect& area, const PixelRect& tile) {
  std::deque<PixelRect>& tiles = wanted_.back().tiles;
  tiles.push_back(tile);
  try {
    readback_.ask(source, area);
  } catch (...) {
    tiles.pop_back();
    throw;
  }
}

Expected<void> FrameCapture::take(FramebufferId source, const PixelRect& area) {
  const std::size_t before = wanted_.size();
  try {
    wanted_.push_back({area.width, area.height, {}, {}});
    ask_for_tile(source, area, {0, 0, area.width, area.height});
    return {};
  } catch (const std::bad_alloc&) {
    if (wanted_.size() != before) wanted_.pop_back();
    return no_memory_for(area.width, area.height);
  }
}

std::optional<RawImage> FrameCapture::next(bool wait) {
  while (!wanted_.empty()) {
    Wanted& wanted = wanted_.front();
    while (!wanted.tiles.empty()) {
      auto tile = wait ? readback_.wait() : readback_.poll();
      if (!tile) return std::nullopt;
      const PixelRect at = wanted.tiles.front();
      wanted.tiles.pop_front();
      wanted.is_lost = wanted.is_lost || tile->rgba.empty();
      if (wanted.is_lost) continue;
      if (wanted.picture.rgba.empty())
        wanted.picture = std::move(*tile);
      else
        place(*tile, at, wanted.picture);
    }
    RawImage out = wanted.is_lost ? RawImage{wanted.width, wanted.height, {}} : std::move(wanted.picture);
    const bool is_given_up = wanted.is_given_up;
    wanted_.pop_front();
    if (!is_given_up) return out;
  }
  return std::nullopt;
}

}  // namespace mes::render

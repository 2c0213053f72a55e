// SPDX-License-Identifier: GPL-3.0-or-later
// A device without a GPU: checks every call against the contract of `Device`, keeps buffer contents, and counts.
//
// Guarantees: a call that breaks the contract throws AssertionFailure. Among these are calls with destroyed
// handles, ranges outside their buffer, data of another size than its ranges, more instances than the buffer holds, and
// uniforms that are not finite.
//
// Smallest use:
//     RecordingDevice device;
//     Scene scene(device);
//     ...
//     CHECK(device.counters().bytes_uploaded == 0);
//
// Cost: the memory of the buffers. Threads: one.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "render/device/device.h"

namespace mes::render {

class RecordingDevice final : public Device {
 public:
  BufferId create_buffer(std::size_t bytes) override;
  void destroy_buffer(BufferId buffer) override;
  void resize_buffer(BufferId buffer, std::size_t bytes, std::size_t keep_bytes) override;
  void update_buffer(BufferId buffer, std::span<const ByteRange> ranges, std::span<const std::byte> data) override;
  FramebufferId create_framebuffer(const FramebufferSpec& spec) override;
  void destroy_framebuffer(FramebufferId framebuffer) override;
  void clear(FramebufferId target, const PixelRect& area, const PremultipliedColor& color) override;
  void read_pixels(FramebufferId source, const PixelRect& area, std::span<std::uint8_t> rgba) override;
  TextureId create_texture(int width, int height, std::span<const std::uint8_t> rgba, bool smooth) override;
  TextureId create_mask(int width, int height) override;
  void update_mask(TextureId mask, int first_row, std::span<const std::uint16_t> rows) override;
  void destroy_texture(TextureId texture) override;
  void draw(const DrawCall& call) override;
  void draw_picture(const PictureCall& call) override;
  void composite(FramebufferId target, const PixelRect& area, FramebufferId group,
                 const PremultipliedColor& color) override;
  void paint_mask(FramebufferId target, const PixelRect& area, TextureId mask, std::span<const PixelRect> parts,
                  const PremultipliedColor& color) override;
  void finish() override {}
  /// Initial costs are zero, so that they never change the way of drawing.
  double pixel_cost_ns() const override { return pixel_cost_ns_; }
  void set_pixel_cost_ns(double cost) { pixel_cost_ns_ = cost; }
  double instance_cost_ns() const override { return instance_cost_ns_; }
  /// Call before instances are uploaded: it decides whether buffers keep them.
  void set_instance_cost_ns(double cost) { instance_cost_ns_ = cost; }
  int max_framebuffer_size() const override { return 16384; }
  const DeviceCounters& counters() const override { return counters_; }

  /// All draw calls since the last `forget_calls`, in order.
  const std::vector<DrawCall>& calls() const { return calls_; }
  void forget_calls() {
    calls_.clear();
    picture_calls_.clear();
  }
  std::span<const std::byte> contents(BufferId buffer) const;
  std::size_t buffers_alive() const { return buffers_.size(); }
  std::size_t framebuffers_alive() const { return framebuffers_.size(); }
  std::size_t textures_alive() const { return textures_.size() + masks_.size(); }
  const std::vector<PictureCall>& picture_calls() const { return picture_calls_; }

 private:
  std::vector<std::byte>& bytes_of(BufferId id);
  void check_target(FramebufferId target, const PixelRect& area) const;

  std::map<std::uint32_t, std::vector<std::byte>> buffers_;
  std::map<std::uint32_t, FramebufferSpec> framebuffers_;
  std::set<std::uint32_t> textures_;
  std::map<std::uint32_t, std::pair<int, int>> masks_;  // width and height
  double pixel_cost_ns_ = 0.0;
  double instance_cost_ns_ = 0.0;
  std::vector<DrawCall> calls_;
  std::vector<PictureCall> picture_calls_;
  std::uint32_t next_id_ = 1;
  DeviceCounters counters_;
};

}  // namespace mes::render

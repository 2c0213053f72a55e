// SPDX-License-Identifier: GPL-3.0-or-later
// `Device` on OpenGL 3.3 core. Shaders use double precision where the driver offers it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "render/device/device.h"
#include "render/device/gl_handles.h"
#include "render/device/uniform_ring.h"

namespace mes::render {

struct GlDeviceOptions {
  bool allow_double = true;   ///< false: programs use pairs of floats, as on hardware without doubles
  bool allow_precise = true;  ///< false: programs avoid `precise`, as on drivers of OpenGL 3.3 alone
  // Override the estimates from the name of the renderer.
  std::optional<double> pixel_cost_ns{};
  std::optional<double> instance_cost_ns{};
};

class GlDevice final : public Device {
 public:
  /// A context of OpenGL 3.3 core or later must be current, and stay current as long as the device exists. Throws
  /// AssertionFailure if it is older.
  explicit GlDevice(const GlDeviceOptions& options = {});
  ~GlDevice() override;

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
  void finish() override;
  double pixel_cost_ns() const override { return pixel_cost_ns_; }
  double instance_cost_ns() const override { return instance_cost_ns_; }
  int max_framebuffer_size() const override { return max_size_; }
  const DeviceCounters& counters() const override { return counters_; }

  /// Renderer and version, as the driver reports them.
  std::string description() const;
  bool uses_double() const { return uses_double_; }
  /// The OpenGL name of the texture, for other code that draws in the same context.
  std::uint32_t name_of(TextureId texture) { return texture_of(texture).get(); }
  /// Makes the next glReadPixels read this target, multisampled or not.
  void bind_for_reading(FramebufferId source);
  /// Writes into each pixel of `to` the mean of two by two pixels of `from`, which is twice as wide and high.
  void shrink(FramebufferId target, const PixelRect& to, FramebufferId source, const PixelRect& from);
  /// Copies the pixels of one rectangle to another one, which may have another size and reach out of the target. Only
  /// pixels of `within` change.
  void copy(FramebufferId source, const PixelRect& from, FramebufferId target, const PixelRect& to,
            const PixelRect& within);

 private:
  struct Buffer {
    GlBuffer handle;
    std::size_t bytes = 0;
  };
  struct Framebuffer {
    GlFramebuffer handle;
    GlTexture texture;  ///< the pixels to read; if multisampled, those of `resolve`
    GlRenderbuffer multisampled;
    GlFramebuffer resolve;
    FramebufferSpec spec;
  };
  struct Program {
    GlProgram handle;
    int maps = -1;  ///< location of its sampler
  };

  struct CompositeProgram {
    GlProgram handle;
    int group = -1;
    int tint = -1;
    int corner = -1;
    int channels = -1;
    int parts = -1;
  };

  struct PictureProgram {
    GlProgram handle;
    int picture = -1;
    int place = -1;
    int part = -1;
    int opacity = -1;
  };

  Buffer& buffer_of(BufferId id);
  Framebuffer& framebuffer_of(FramebufferId id);
  GlTexture& texture_of(TextureId id);
  Program& program_of(const ProgramKey& key);
  void bind_target(FramebufferId target, const PixelRect& area);
  void begin_painting_over();
  void end_painting_over();
  void paint_texture(FramebufferId target, const PixelRect& area, const GlTexture& texture, int channels,
                     std::span<const PixelRect> parts, const PremultipliedColor& color);
  /// Makes multisampled pixels readable. Returns the framebuffer to read from.
  unsigned resolved(FramebufferId source);

  std::map<std::uint32_t, Buffer> buffers_;
  std::map<std::uint32_t, Framebuffer> framebuffers_;
  std::map<ProgramKey, Program> programs_;
  UniformRing uniforms_;
  std::map<std::uint32_t, GlTexture> textures_;
  std::map<std::uint32_t, int> mask_widths_;
  CompositeProgram composite_;
  PictureProgram picture_;
  GlVertexArray vertex_array_;
  std::uint32_t next_id_ = 1;
  double pixel_cost_ns_ = 0.0;
  double instance_cost_ns_ = 0.0;
  int max_size_ = 0;
  int max_samples_ = 1;
  bool uses_double_ = false;
  bool uses_precise_ = false;
  DeviceCounters counters_;
};

}  // namespace mes::render

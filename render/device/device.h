// SPDX-License-Identifier: GPL-3.0-or-later
// The graphics interface that the scene needs: instance buffers, off-screen targets, textures, and draw calls of
// instances.
//
// Guarantees:
//  1. A handle is never reused; using a destroyed one is a broken invariant (MES_ASSERT).
//  2. `resize_buffer` keeps the requested bytes; all others are undefined until they are updated.
//  3. A draw call does not depend on the state left by an earlier one.
//  4. `counters()` counts the bytes of instances; uniforms do not count as uploads.
//
// Smallest use:
//     GlDevice device;                       // a current OpenGL context is needed
//     BufferId buffer = device.create_buffer(1024);
//     device.draw({.program = {PrimitiveKind::point}, .buffer = buffer, ...});
//
// Cost: a handful of driver calls a draw call. Threads: the one that owns the context.
// Implementations: `GlDevice` (OpenGL 3.3 core), `RecordingDevice` (no GPU: checks and counts).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "core/draw/primitives.h"
#include "render/device/convert.h"
#include "render/device/draw_uniforms.h"

namespace mes::render {

/// Handles. Zero means no object; a framebuffer of zero is the window's.
struct BufferId {
  std::uint32_t value = 0;
  friend constexpr auto operator<=>(BufferId, BufferId) = default;
};
struct FramebufferId {
  std::uint32_t value = 0;
  friend constexpr auto operator<=>(FramebufferId, FramebufferId) = default;
};
struct TextureId {
  std::uint32_t value = 0;
  friend constexpr auto operator<=>(TextureId, TextureId) = default;
};

/// Bytes `offset .. offset + size` of a buffer.
struct ByteRange {
  std::size_t offset = 0;
  std::size_t size = 0;
};

/// Pixels of a target; the origin is its lower left corner, as in OpenGL.
struct PixelRect {
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
  friend constexpr bool operator==(const PixelRect&, const PixelRect&) = default;
};

enum class TargetFormat : std::uint8_t {
  color,     ///< RGBA, 8 bits a channel, premultiplied
  coverage,  ///< one channel, 8 bits: the part of the pixel that a group of primitives of one colour covers
};

struct FramebufferSpec {
  int width = 1;
  int height = 1;
  TargetFormat format = TargetFormat::color;
  int samples = 1;  ///< multisampling; 1: off, and enough, because edges are analytic
};

/// The precision with which a program places long lines and large circles relative to the centre of the view.
enum class Reach : std::uint8_t {
  near,  ///< single: exact enough up to about 10^5 pixels from the centre
  far,   ///< twice as many bits: for deep zoom, and coordinates far outside the view
};

/// True for the kinds that are drawn as `DrawUniforms::arc_pieces` quads along a curve.
constexpr bool is_curve(PrimitiveKind kind) {
  return kind == PrimitiveKind::circle || kind == PrimitiveKind::arc || kind == PrimitiveKind::parabola;
}

/// Selects a program; each is compiled at its first use.
struct ProgramKey {
  PrimitiveKind kind = PrimitiveKind::point;
  Reach reach = Reach::near;
  bool dashed = false;
  bool mapped = false;  ///< each instance has the colour of its scalar in a colour map
  friend constexpr auto operator<=>(const ProgramKey&, const ProgramKey&) = default;
};

enum class Blend : std::uint8_t {
  over,  ///< premultiplied source over destination
  add,   ///< saturating sum, for the coverage of pieces that do not overlap
};

struct DrawCall {
  FramebufferId target;
  PixelRect area;  ///< part of the target; pixels outside do not change
  ProgramKey program;
  Blend blend = Blend::over;
  BufferId buffer;
  BufferId scalars;         ///< one double an instance, for a program with a colour map
  TextureId maps;           ///< one colour map a row
  std::uint32_t first = 0;  ///< first instance in the buffers
  std::uint32_t instances = 0;
  std::uint32_t every = 1;  ///< draws only the instances first, first + every, first + 2 every, ...
  DrawUniforms uniforms;
};

/// Paints a part of a picture on a part of a target.
struct PictureCall {
  FramebufferId target;
  PixelRect area;  ///< part of the target; pixels outside do not change
  TextureId texture;
  glm::vec4 place{};  ///< left, bottom, right, top edges in pixels from the centre of the area
  glm::vec4 part{};   ///< the same edges in the picture, from 0 at its left and top to 1
  float opacity = 1.0F;
};

struct DeviceCounters {
  std::uint64_t bytes_uploaded = 0;
  std::uint64_t updates = 0;  ///< written contiguous ranges
  std::uint64_t draw_calls = 0;
  std::uint64_t instances_drawn = 0;
  std::uint64_t composites = 0;
  std::uint64_t masks = 0;            ///< masks painted
  std::uint64_t mask_rows = 0;        ///< mask rows written
  std::uint64_t bytes_allocated = 0;  ///< bytes of all existing instance buffers
};

class Device {
 public:
  Device() = default;
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Throws std::bad_alloc when graphics memory is exhausted, as does every call that allocates.
  virtual BufferId create_buffer(std::size_t bytes) = 0;
  virtual void destroy_buffer(BufferId buffer) = 0;
  /// Keeps the first `keep_bytes` bytes, at most the old and the new size.
  virtual void resize_buffer(BufferId buffer, std::size_t bytes, std::size_t keep_bytes) = 0;
  /// `data` is the concatenation of the bytes of all ranges. The ranges do not overlap and lie inside the buffer.
  virtual void update_buffer(BufferId buffer, std::span<const ByteRange> ranges, std::span<const std::byte> data) = 0;

  virtual FramebufferId create_framebuffer(const FramebufferSpec& spec) = 0;
  virtual void destroy_framebuffer(FramebufferId framebuffer) = 0;
  /// Fills `area` of the target.
  virtual void clear(FramebufferId target, const PixelRect& area, const PremultipliedColor& color) = 0;
  /// Writes the RGBA bytes of `area`, premultiplied, bottom row first. Waits until drawing has ended.
  virtual void read_pixels(FramebufferId source, const PixelRect& area, std::span<std::uint8_t> rgba) = 0;

  /// Takes RGBA bytes, premultiplied, top row first. A smooth texture can be drawn at any size.
  virtual TextureId create_texture(int width, int height, std::span<const std::uint8_t> rgba, bool smooth) = 0;
  /// A mask has one channel of 16 bits; its contents are undefined until they are written.
  virtual TextureId create_mask(int width, int height) = 0;
  /// Writes whole rows from `first_row` on; row 0 is the lowest.
  virtual void update_mask(TextureId mask, int first_row, std::span<const std::uint16_t> rows) = 0;
  virtual void destroy_texture(TextureId texture) = 0;

  virtual void draw(const DrawCall& call) = 0;
  virtual void draw_picture(const PictureCall& call) = 0;
  /// Paints `group` on `area`, aligned at the lower left corners, each pixel multiplied by `color`. A coverage group
  /// counts as white with that alpha.
  virtual void composite(FramebufferId target, const PixelRect& area, FramebufferId group,
                         const PremultipliedColor& color) = 0;

  /// Paints `color`, each pixel multiplied by the mask, on parts of `area`, aligned at the lower left corners. The
  /// parts are relative to the area and do not overlap.
  virtual void paint_mask(FramebufferId target, const PixelRect& area, TextureId mask,
                          std::span<const PixelRect> parts, const PremultipliedColor& color) = 0;

  /// Waits until all drawing has ended.
  virtual void finish() = 0;
  /// Approximate nanoseconds to blend one pixel of a large shape.
  virtual double pixel_cost_ns() const = 0;
  /// Approximate nanoseconds to place one short stroke or dot and blend its pixels.
  virtual double instance_cost_ns() const = 0;
  /// The largest width and height of a framebuffer or texture.
  virtual int max_framebuffer_size() const = 0;
  virtual const DeviceCounters& counters() const = 0;
};

}  // namespace mes::render

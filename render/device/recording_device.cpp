// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/recording_device.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <initializer_list>

#include "core/base/assert.h"
#include "render/device/instance_layout.h"

namespace mes::render {
namespace {

/// Fills undefined contents; as coordinates, these are numbers that no test expects.
constexpr std::byte kUndefined{0xcd};

template <int N>
bool are_finite(const glm::vec<N, float>& values) {
  return !glm::any(glm::isnan(values)) && !glm::any(glm::isinf(values));
}

bool are_finite(std::initializer_list<float> values) {
  return std::ranges::all_of(values, [](float v) { return std::isfinite(v); });
}

bool is_color(const PremultipliedColor& color) {
  const glm::vec4 most(std::min(color.a, 1.0F));
  return glm::all(glm::greaterThanEqual(color, glm::vec4(0.0F))) && glm::all(glm::lessThanEqual(color, most));
}

}  // namespace

std::vector<std::byte>& RecordingDevice::bytes_of(BufferId id) {
  const auto found = buffers_.find(id.value);
  MES_ASSERT(found != buffers_.end());
  return found->second;
}

std::span<const std::byte> RecordingDevice::contents(BufferId buffer) const {
  const auto found = buffers_.find(buffer.value);
  MES_ASSERT(found != buffers_.end());
  return found->second;
}

void RecordingDevice::check_target(FramebufferId target, const PixelRect& area) const {
  MES_ASSERT(area.width > 0 && area.height > 0);
  if (target == FramebufferId{}) return;
  const auto found = framebuffers_.find(target.value);
  MES_ASSERT(found != framebuffers_.end());
  MES_ASSERT(area.left >= 0 && area.left + area.width <= found->second.width);
  MES_ASSERT(area.bottom >= 0 && area.bottom + area.height <= found->second.height);
}

BufferId RecordingDevice::create_buffer(std::size_t bytes) {
  MES_ASSERT(bytes > 0);
  const BufferId id{next_id_++};
  buffers_.emplace(id.value, std::vector<std::byte>(bytes, kUndefined));
  counters_.bytes_allocated += bytes;
  return id;
}

void RecordingDevice::destroy_buffer(BufferId buffer) {
  counters_.bytes_allocated -= bytes_of(buffer).size();
  buffers_.erase(buffer.value);
}

void RecordingDevice::resize_buffer(BufferId buffer, std::size_t bytes, std::size_t keep_bytes) {
  std::vector<std::byte>& old = bytes_of(buffer);
  MES_ASSERT(bytes > 0 && keep_bytes <= bytes && keep_bytes <= old.size());
  std::vector<std::byte> resized(bytes, kUndefined);
  std::copy_n(old.begin(), keep_bytes, resized.begin());
  counters_.bytes_allocated += bytes;
  counters_.bytes_allocated -= old.size();
  old = std::move(resized);
}

void RecordingDevice::update_buffer(BufferId buffer, std::span<const ByteRange> ranges,
                                    std::span<const std::byte> data) {
  std::vector<std::byte>& bytes = bytes_of(buffer);
  std::vector<ByteRange> sorted(ranges.begin(), ranges.end());
  std::ranges::sort(sorted, {}, &ByteRange::offset);
  std::size_t end = 0;
  for (const ByteRange& range : sorted) {
    MES_ASSERT(range.size > 0 && range.offset >= end);
    end = range.offset + range.size;
  }
  MES_ASSERT(end <= bytes.size());
  std::size_t from = 0;
  for (const ByteRange& range : ranges) {
    MES_ASSERT(from + range.size <= data.size());
    std::memcpy(bytes.data() + range.offset, data.data() + from, range.size);
    from += range.size;
  }
  MES_ASSERT(from == data.size());
  counters_.bytes_uploaded += from;
  counters_.updates += ranges.size();
}

FramebufferId RecordingDevice::create_framebuffer(const FramebufferSpec& spec) {
  MES_ASSERT(spec.width > 0 && spec.height > 0 && spec.samples >= 1);
  MES_ASSERT(spec.width <= max_framebuffer_size() && spec.height <= max_framebuffer_size());
  const FramebufferId id{next_id_++};
  framebuffers_.emplace(id.value, spec);
  return id;
}

void RecordingDevice::destroy_framebuffer(FramebufferId framebuffer) {
  MES_ASSERT(framebuffers_.erase(framebuffer.value) == 1);
}

void RecordingDevice::clear(FramebufferId target, const PixelRect& area, const PremultipliedColor& color) {
  check_target(target, area);
  MES_ASSERT(is_color(color));
}

void RecordingDevice::read_pixels(FramebufferId source, const PixelRect& area, std::span<std::uint8_t> rgba) {
  check_target(source, area);
  MES_ASSERT(rgba.size() ==
             std::size_t{4} * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
  std::ranges::fill(rgba, std::uint8_t{0});
}

TextureId RecordingDevice::create_texture(int width, int height, std::span<const std::uint8_t> rgba,
                                          bool /*smooth*/) {
  MES_ASSERT(width > 0 && height > 0 && width <= max_framebuffer_size() && height <= max_framebuffer_size());
  MES_ASSERT(rgba.size() == std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const TextureId id{next_id_++};
  textures_.insert(id.value);
  return id;
}

TextureId RecordingDevice::create_mask(int width, int height) {
  MES_ASSERT(width > 0 && height > 0 && width <= max_framebuffer_size() && height <= max_framebuffer_size());
  const TextureId id{next_id_++};
  masks_.emplace(id.value, std::pair{width, height});
  return id;
}

void RecordingDevice::update_mask(TextureId mask, int first_row, std::span<const std::uint16_t> rows) {
  const auto found = masks_.find(mask.value);
  MES_ASSERT(found != masks_.end());
  const auto [width, height] = found->second;
  const auto pixels = static_cast<std::size_t>(width);
  MES_ASSERT(first_row >= 0 && !rows.empty() && rows.size() % pixels == 0);
  MES_ASSERT(static_cast<std::size_t>(first_row) + rows.size() / pixels <= static_cast<std::size_t>(height));
  counters_.mask_rows += rows.size() / pixels;
}

void RecordingDevice::destroy_texture(TextureId texture) {
  MES_ASSERT(textures_.erase(texture.value) + masks_.erase(texture.value) == 1);
}

void RecordingDevice::draw(const DrawCall& call) {
  check_target(call.target, call.area);
  MES_ASSERT(call.instances > 0 && call.every > 0);
  const std::size_t end = std::size_t{call.first} + call.instances;
  MES_ASSERT(end * layout_of(call.program.kind).bytes() <= bytes_of(call.buffer).size());
  const DrawUniforms& u = call.uniforms;
  MES_ASSERT(are_finite(u.center_1) && are_finite(u.center_2) && are_finite(u.center_3));
  MES_ASSERT(are_finite(
      {u.pixels_per_unit, u.half_width_px, u.view_radius_px, u.ring_px, u.dash_px, u.dash_period_px, u.arc_pieces}));
  MES_ASSERT(u.pixels_per_unit > 0.0F && u.half_view_px.x > 0.0F && u.half_view_px.y > 0.0F && u.one == 1.0F);
  MES_ASSERT(!call.program.dashed || u.dash_period_px > 0.0F);
  MES_ASSERT(!is_curve(call.program.kind) || u.arc_pieces == 0.0F ||
             u.arc_pieces >= (call.program.kind == PrimitiveKind::parabola ? 1.0F : 3.0F));
  MES_ASSERT(is_color(u.color));
  if (call.program.mapped) {
    MES_ASSERT(end * sizeof(double) <= bytes_of(call.scalars).size());
    MES_ASSERT(textures_.contains(call.maps.value));
    MES_ASSERT(are_finite(u.map_low));
    MES_ASSERT(are_finite({u.map_factor, u.map_exponent, u.map_offset, u.map_row, u.map_categories}));
  }
  calls_.push_back(call);
  ++counters_.draw_calls;
  counters_.instances_drawn += (call.instances + call.every - 1) / call.every;
}

void RecordingDevice::draw_picture(const PictureCall& call) {
  check_target(call.target, call.area);
  MES_ASSERT(textures_.contains(call.texture.value));
  MES_ASSERT(are_finite(call.place) && are_finite(call.part));
  MES_ASSERT(call.opacity >= 0.0F && call.opacity <= 1.0F);
  picture_calls_.push_back(call);
}

void RecordingDevice::composite(FramebufferId target, const PixelRect& area, FramebufferId group,
                                const PremultipliedColor& color) {
  check_target(target, area);
  const auto found = framebuffers_.find(group.value);
  MES_ASSERT(found != framebuffers_.end());
  MES_ASSERT(target != group && found->second.width >= area.width && found->second.height >= area.height);
  MES_ASSERT(is_color(color));
  ++counters_.composites;
}

void RecordingDevice::paint_mask(FramebufferId target, const PixelRect& area, TextureId mask,
                                 std::span<const PixelRect> parts, const PremultipliedColor& color) {
  check_target(target, area);
  const auto found = masks_.find(mask.value);
  MES_ASSERT(found != masks_.end());
  MES_ASSERT(found->second.first >= area.width && found->second.second >= area.height);
  for (const PixelRect& part : parts)
    MES_ASSERT(part.left >= 0 && part.bottom >= 0 && part.left + part.width <= area.width &&
               part.bottom + part.height <= area.height);
  MES_ASSERT(is_color(color));
  ++counters_.masks;
}

}  // namespace mes::render

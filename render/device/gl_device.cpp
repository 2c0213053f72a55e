// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/gl_device.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <new>
#include <string_view>

#include "core/base/assert.h"
#include "render/device/gl_dialect.h"
#include "render/device/gl_programs.h"
#include "render/device/instance_layout.h"

namespace mes::render {
namespace {

// More ranges than this are written through one mapping instead of one call each: the fixed cost of some hundred calls
// exceeds that of waiting for the drawing in flight.
constexpr std::size_t kMapFrom = 512;

/// The largest number of columns of any layout.
constexpr GLuint kColumns = 5;
/// The scalar's column follows all of them.
constexpr GLuint kScalarColumn = kColumns;

/// Vertices of one instance, as a triangle strip.
GLsizei vertices_of(const DrawCall& call) {
  if (call.program.kind == PrimitiveKind::point) return 3;
  if (!is_curve(call.program.kind) || call.uniforms.arc_pieces == 0.0F) return 4;
  return 2 * (static_cast<GLsizei>(call.uniforms.arc_pieces) + 1);
}

void throw_if_out_of_memory() {
  // Earlier errors are not reported here, but must leave the queue.
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
  }
}

GlBuffer make_buffer(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(std::numeric_limits<GLsizeiptr>::max())) throw std::bad_alloc();
  GLuint name = 0;
  glGenBuffers(1, &name);
  GlBuffer buffer(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
  throw_if_out_of_memory();
  return buffer;
}

GLenum internal_format(TargetFormat format) {
  return format == TargetFormat::color ? GL_RGBA8 : GL_R8;
}

GlTexture make_texture(const FramebufferSpec& spec) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  const bool is_color = spec.format == TargetFormat::color;
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format(spec.format)), spec.width, spec.height, 0,
               is_color ? GL_RGBA : GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  throw_if_out_of_memory();
  return texture;
}

std::string text_of(GLenum name) {
  const auto* bytes = glGetString(name);
  return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes));
}

/// Parts painted in one draw call; composite.vert has the same number.
constexpr std::size_t kPaintedParts = 128;

bool is_software(std::string_view renderer) {
  constexpr std::array<std::string_view, 4> kSoftware{"llvmpipe", "softpipe", "swrast", "SwiftShader"};
  return std::ranges::any_of(kSoftware,
                             [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

struct Costs {
  double pixel_ns;
  double instance_ns;
};

/// Software costs were measured with llvmpipe on two cores; those of graphics cards are of a slow one.
Costs costs_of(std::string_view renderer) {
  return is_software(renderer) ? Costs{3.0, 1000.0} : Costs{0.1, 10.0};
}

GlFramebuffer make_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return GlFramebuffer(name);
}

}  // namespace

GlDevice::GlDevice(const GlDeviceOptions& options) {
  if (!has_needed_gl()) throw AssertionFailure("OpenGL 3.3 is needed");
  int texture = 0;
  int renderbuffer = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  std::array<int, 2> viewport{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  max_size_ = std::min({texture, renderbuffer, viewport[0], viewport[1]});
  glGetIntegerv(GL_MAX_SAMPLES, &max_samples_);
  uses_precise_ = options.allow_precise && has_gl_extension("GL_ARB_gpu_shader5");
  uses_double_ = options.allow_double && uses_precise_ && has_gl_extension("GL_ARB_gpu_shader_fp64");
  const Costs costs = costs_of(text_of(GL_RENDERER));
  pixel_cost_ns_ = options.pixel_cost_ns.value_or(costs.pixel_ns);
  instance_cost_ns_ = options.instance_cost_ns.value_or(costs.instance_ns);
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  vertex_array_ = GlVertexArray(name);
  composite_.handle = build_composite_program();
  composite_.group = glGetUniformLocation(composite_.handle.get(), "u_group");
  composite_.tint = glGetUniformLocation(composite_.handle.get(), "u_tint");
  composite_.corner = glGetUniformLocation(composite_.handle.get(), "u_corner");
  composite_.channels = glGetUniformLocation(composite_.handle.get(), "u_channels");
  composite_.parts = glGetUniformLocation(composite_.handle.get(), "u_parts");
  picture_.handle = build_picture_program();
  picture_.picture = glGetUniformLocation(picture_.handle.get(), "u_picture");
  picture_.place = glGetUniformLocation(picture_.handle.get(), "u_place");
  picture_.part = glGetUniformLocation(picture_.handle.get(), "u_part");
  picture_.opacity = glGetUniformLocation(picture_.handle.get(), "u_opacity");
}

GlDevice::~GlDevice() = default;

GlDevice::Buffer& GlDevice::buffer_of(BufferId id) {
  const auto found = buffers_.find(id.value);
  MES_ASSERT(found != buffers_.end());
  return found->second;
}

GlDevice::Framebuffer& GlDevice::framebuffer_of(FramebufferId id) {
  const auto found = framebuffers_.find(id.value);
  MES_ASSERT(found != framebuffers_.end());
  return found->second;
}

GlTexture& GlDevice::texture_of(TextureId id) {
  const auto found = textures_.find(id.value);
  MES_ASSERT(found != textures_.end());
  return found->second;
}

GlDevice::Program& GlDevice::program_of(const ProgramKey& key) {
  Program& program = programs_[key];
  if (program.handle.get() == 0) {
    program.handle = build_program(key, {.use_double = uses_double_, .use_precise = uses_precise_});
    program.maps = glGetUniformLocation(program.handle.get(), "u_maps");
  }
  return program;
}

BufferId GlDevice::create_buffer(std::size_t bytes) {
  Buffer buffer{make_buffer(bytes), bytes};
  const BufferId id{next_id_++};
  buffers_.emplace(id.value, std::move(buffer));
  counters_.bytes_allocated += bytes;
  return id;
}

void GlDevice::destroy_buffer(BufferId buffer) {
  counters_.bytes_allocated -= buffer_of(buffer).bytes;
  buffers_.erase(buffer.value);
}

void GlDevice::resize_buffer(BufferId id, std::size_t bytes, std::size_t keep_bytes) {
  Buffer& buffer = buffer_of(id);
  MES_ASSERT(keep_bytes <= bytes && keep_bytes <= buffer.bytes);
  GlBuffer grown = make_buffer(bytes);
  if (keep_bytes > 0) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.handle.get());
    glBindBuffer(GL_COPY_WRITE_BUFFER, grown.get());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(keep_bytes));
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  }
  counters_.bytes_allocated += bytes;
  counters_.bytes_allocated -= buffer.bytes;
  buffer.handle = std::move(grown);
  buffer.bytes = bytes;
}

void GlDevice::update_buffer(BufferId id, std::span<const ByteRange> ranges, std::span<const std::byte> data) {
  if (ranges.empty()) return;
  const Buffer& buffer = buffer_of(id);
  std::size_t low = ranges.front().offset;
  std::size_t high = 0;
  std::size_t total = 0;
  for (const ByteRange& range : ranges) {
    low = std::min(low, range.offset);
    high = std::max(high, range.offset + range.size);
    total += range.size;
  }
  MES_ASSERT(high <= buffer.bytes && total == data.size());

  glBindBuffer(GL_ARRAY_BUFFER, buffer.handle.get());
  std::byte* mapped = nullptr;
  if (ranges.size() > kMapFrom) {
    mapped = map_to_write(low, high - low);
  }
  const auto write = [&](std::byte* to) {
    std::size_t from = 0;
    for (const ByteRange& range : ranges) {
      if (to != nullptr) {
        std::memcpy(to + (range.offset - low), data.data() + from, range.size);
      } else {
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(range.offset), static_cast<GLsizeiptr>(range.size),
                        data.data() + from);
      }
      from += range.size;
    }
  };
  write(mapped);
  if (mapped != nullptr && !unmap_written()) write(nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  counters_.bytes_uploaded += total;
  counters_.updates += ranges.size();
}

FramebufferId GlDevice::create_framebuffer(const FramebufferSpec& spec) {
  MES_ASSERT(spec.width > 0 && spec.height > 0 && spec.width <= max_size_ && spec.height <= max_size_);
  Framebuffer target;
  target.spec = spec;
  target.spec.samples = std::clamp(spec.samples, 1, max_samples_);
  target.texture = make_texture(spec);
  target.handle = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, target.handle.get());
  if (target.spec.samples == 1) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.get(), 0);
  } else {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    target.multisampled = GlRenderbuffer(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, target.spec.samples, internal_format(spec.format), spec.width,
                                     spec.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
    target.resolve = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, target.resolve.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.get(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, target.handle.get());
  }
  throw_if_out_of_memory();
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) throw std::bad_alloc();
  const FramebufferId id{next_id_++};
  framebuffers_.emplace(id.value, std::move(target));
  return id;
}

void GlDevice::destroy_framebuffer(FramebufferId framebuffer) {
  static_cast<void>(framebuffer_of(framebuffer));
  framebuffers_.erase(framebuffer.value);
}

TextureId GlDevice::create_texture(int width, int height, std::span<const std::uint8_t> rgba, bool smooth) {
  MES_ASSERT(width > 0 && height > 0 && width <= max_size_ && height <= max_size_);
  MES_ASSERT(rgba.size() == std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smooth ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  if (smooth)
    glGenerateMipmap(GL_TEXTURE_2D);
  else
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  throw_if_out_of_memory();
  const TextureId id{next_id_++};
  textures_.emplace(id.value, std::move(texture));
  return id;
}

TextureId GlDevice::create_mask(int width, int height) {
  MES_ASSERT(width > 0 && height > 0 && width <= max_size_ && height <= max_size_);
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  const MaskFormat mask = mask_format();
  glTexImage2D(GL_TEXTURE_2D, 0, mask.internal, width, height, 0, mask.format, mask.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  throw_if_out_of_memory();
  const TextureId id{next_id_++};
  textures_.emplace(id.value, std::move(texture));
  mask_widths_.emplace(id.value, width);
  return id;
}

void GlDevice::update_mask(TextureId mask, int first_row, std::span<const std::uint16_t> rows) {
  const auto width = mask_widths_.find(mask.value);
  MES_ASSERT(width != mask_widths_.end() && rows.size() % static_cast<std::size_t>(width->second) == 0);
  glBindTexture(GL_TEXTURE_2D, texture_of(mask).get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, width->second,
                  static_cast<GLsizei>(rows.size() / static_cast<std::size_t>(width->second)), mask_format().format,
                  mask_format().type, rows.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  counters_.mask_rows += rows.size() / static_cast<std::size_t>(width->second);
}

void GlDevice::destroy_texture(TextureId texture) {
  static_cast<void>(texture_of(texture));
  textures_.erase(texture.value);
  mask_widths_.erase(texture.value);
}

void GlDevice::bind_target(FramebufferId target, const PixelRect& area) {
  glBindFramebuffer(GL_FRAMEBUFFER, target == FramebufferId{} ? 0 : framebuffer_of(target).handle.get());
  glViewport(area.left, area.bottom, area.width, area.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
}

void GlDevice::clear(FramebufferId target, const PixelRect& area, const PremultipliedColor& color) {
  bind_target(target, area);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(color.r, color.g, color.b, color.a);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

unsigned GlDevice::resolved(FramebufferId source) {
  if (source == FramebufferId{}) return 0;
  const Framebuffer& framebuffer = framebuffer_of(source);
  if (framebuffer.spec.samples == 1) return framebuffer.handle.get();
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.handle.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.resolve.get());
  glBlitFramebuffer(0, 0, framebuffer.spec.width, framebuffer.spec.height, 0, 0, framebuffer.spec.width,
                    framebuffer.spec.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return framebuffer.resolve.get();
}

void GlDevice::read_pixels(FramebufferId source, const PixelRect& area, std::span<std::uint8_t> rgba) {
  MES_ASSERT(area.width >= 0 && area.height >= 0);
  MES_ASSERT(rgba.size() ==
             std::size_t{4} * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
  bind_for_reading(source);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(area.left, area.bottom, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GlDevice::draw(const DrawCall& call) {
  MES_ASSERT(call.every > 0);
  if (call.instances == 0 || call.area.width <= 0 || call.area.height <= 0) return;
  const Buffer& buffer = buffer_of(call.buffer);
  const InstanceLayout layout = layout_of(call.program.kind);
  MES_ASSERT((std::size_t{call.first} + call.instances) * layout.bytes() <= buffer.bytes);
  const Program& program = program_of(call.program);
  bind_target(call.target, call.area);

  glUseProgram(program.handle.get());
  uniforms_.bind(kUniformBindingPoint, call.uniforms);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, call.blend == Blend::over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);

  GLuint scalars = 0;
  if (call.program.mapped) {
    const Buffer& of_scalars = buffer_of(call.scalars);
    MES_ASSERT((std::size_t{call.first} + call.instances) * sizeof(double) <= of_scalars.bytes);
    scalars = of_scalars.handle.get();
    glUniform1i(program.maps, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_of(call.maps).get());
  }

  glBindVertexArray(vertex_array_.get());
  // Draws the instances `first`, `first` + `step`, ...
  const auto draw_from = [&](std::size_t first, std::size_t step, std::uint32_t count) {
    std::size_t offset = first * layout.bytes();
    const auto column = [&](GLuint location, GLint words, std::size_t stride) {
      // NOLINTNEXTLINE(performance-no-int-to-ptr): this interface takes the offset into the buffer as a pointer.
      const auto* start = reinterpret_cast<const void*>(offset);
      glVertexAttribIPointer(location, words, GL_UNSIGNED_INT, static_cast<GLsizei>(stride), start);
      glVertexAttribDivisor(location, 1);
      glEnableVertexAttribArray(location);
      offset += sizeof(std::uint32_t) * static_cast<std::size_t>(words);
    };
    glBindBuffer(GL_ARRAY_BUFFER, buffer.handle.get());
    GLuint location = 0;
    for (int i = 0; i < layout.points; ++i) column(location++, 4, step * layout.bytes());
    for (int i = 0; i < layout.numbers; ++i) column(location++, 2, step * layout.bytes());
    for (GLuint unused = location; unused <= kScalarColumn; ++unused) glDisableVertexAttribArray(unused);
    if (scalars != 0) {
      glBindBuffer(GL_ARRAY_BUFFER, scalars);
      offset = first * sizeof(double);
      column(kScalarColumn, 2, step * sizeof(double));
    }
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, vertices_of(call), static_cast<GLsizei>(count));
  };
  // Drivers need not support a larger stride; beyond it the few remaining instances are drawn one by one.
  constexpr std::size_t kLargestStride = 2048;
  const std::uint32_t drawn = (call.instances + call.every - 1) / call.every;
  if (layout.bytes() * call.every <= kLargestStride) {
    draw_from(call.first, call.every, drawn);
  } else {
    for (std::uint32_t i = 0; i < drawn; ++i) draw_from(call.first + std::size_t{i} * call.every, 1, 1);
  }

  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  if (call.program.mapped) glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
  ++counters_.draw_calls;
  counters_.instances_drawn += drawn;
}

void GlDevice::draw_picture(const PictureCall& call) {
  bind_target(call.target, call.area);
  glUseProgram(picture_.handle.get());
  const glm::vec2 half_area = 0.5F * glm::vec2(call.area.width, call.area.height);
  const glm::vec4 place = call.place / glm::vec4(half_area, half_area);
  glUniform4fv(picture_.place, 1, glm::value_ptr(place));
  glUniform4fv(picture_.part, 1, glm::value_ptr(call.part));
  glUniform1f(picture_.opacity, call.opacity);
  glUniform1i(picture_.picture, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_of(call.texture).get());
  begin_painting_over();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  end_painting_over();
}

// For programs that read no instances.
void GlDevice::begin_painting_over() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(vertex_array_.get());
  for (GLuint unused = 0; unused <= kScalarColumn; ++unused) glDisableVertexAttribArray(unused);
}

// Resets the state.
void GlDevice::end_painting_over() {
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
}

void GlDevice::composite(FramebufferId target, const PixelRect& area, FramebufferId group,
                         const PremultipliedColor& color) {
  static_cast<void>(resolved(group));
  const PixelRect all{0, 0, area.width, area.height};
  const Framebuffer& painted = framebuffer_of(group);
  constexpr int kColor = 4;
  constexpr int kCoverage = 1;
  paint_texture(target, area, painted.texture, painted.spec.format == TargetFormat::color ? kColor : kCoverage,
                std::span(&all, 1), color);
  ++counters_.composites;
}

void GlDevice::paint_mask(FramebufferId target, const PixelRect& area, TextureId mask,
                          std::span<const PixelRect> parts, const PremultipliedColor& color) {
  MES_ASSERT(mask_widths_.contains(mask.value));
  paint_texture(target, area, texture_of(mask), mask_format().channels, parts, color);
  ++counters_.masks;
}

// Maps pixels one to one.
void GlDevice::paint_texture(FramebufferId target, const PixelRect& area, const GlTexture& texture, int channels,
                             std::span<const PixelRect> parts, const PremultipliedColor& color) {
  bind_target(target, area);
  glUseProgram(composite_.handle.get());
  glUniform4fv(composite_.tint, 1, glm::value_ptr(color));
  glUniform2i(composite_.corner, area.left, area.bottom);
  glUniform1i(composite_.group, 0);
  glUniform1i(composite_.channels, channels);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.get());
  begin_painting_over();
  const glm::vec4 size(area.width, area.height, area.width, area.height);
  std::array<glm::vec4, kPaintedParts> places;
  for (std::size_t first = 0; first < parts.size(); first += places.size()) {
    const std::size_t count = std::min(places.size(), parts.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const PixelRect& part = parts[first + i];
      const glm::vec4 edges(part.left, part.bottom, part.left + part.width, part.bottom + part.height);
      places[i] = 2.0F * edges / size - 1.0F;
    }
    glUniform4fv(composite_.parts, static_cast<GLsizei>(count), glm::value_ptr(places[0]));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  }
  end_painting_over();
}

std::string GlDevice::description() const {
  return text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
}

void GlDevice::bind_for_reading(FramebufferId source) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved(source));
}

void GlDevice::shrink(FramebufferId target, const PixelRect& to, FramebufferId source, const PixelRect& from) {
  MES_ASSERT(from.width == 2 * to.width && from.height == 2 * to.height);
  bind_for_reading(source);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_of(target).handle.get());
  glDisable(GL_SCISSOR_TEST);
  // At the corner between four pixels a linear filter yields their mean.
  glBlitFramebuffer(from.left, from.bottom, from.left + from.width, from.bottom + from.height, to.left, to.bottom,
                    to.left + to.width, to.bottom + to.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GlDevice::copy(FramebufferId source, const PixelRect& from, FramebufferId target, const PixelRect& to,
                    const PixelRect& within) {
  bind_for_reading(source);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target == FramebufferId{} ? 0 : framebuffer_of(target).handle.get());
  glEnable(GL_SCISSOR_TEST);
  glScissor(within.left, within.bottom, within.width, within.height);
  const bool is_same_size = from.width == to.width && from.height == to.height;
  glBlitFramebuffer(from.left, from.bottom, from.left + from.width, from.bottom + from.height, to.left, to.bottom,
                    to.left + to.width, to.bottom + to.height, GL_COLOR_BUFFER_BIT,
                    is_same_size ? GL_NEAREST : GL_LINEAR);
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GlDevice::finish() {
  glFinish();
}

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// WebGL 2.
#include "render/device/gl_dialect.h"

#include <webgl/webgl2.h>

namespace mes::render {

std::string_view shader_head() {
  return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
}

const char* shader_version() {
  return "#version 300 es";
}

bool has_needed_gl() {
  return glGetString(GL_VERSION) != nullptr;
}

bool has_gl_extension(const char* /*name*/) {
  return false;
}

// WebGL cannot read textures of 16 bits on every machine, so the low and the high byte have a channel each.
MaskFormat mask_format() {
  return {.internal = GL_RG8, .format = GL_RG, .type = GL_UNSIGNED_BYTE, .channels = 2};
}

std::byte* map_to_write(std::size_t /*offset*/, std::size_t /*size*/) {
  return nullptr;
}

bool unmap_written() {
  return true;
}

// A page must not wait; what reads the buffer does.
void wait_for(GLsync /*fence*/) {}

bool read_packed(std::span<std::uint8_t> to) {
  emscripten_glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(to.size()), to.data());
  return true;
}

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/gl_dialect.h"

#include <cstring>
#include <limits>

namespace mes::render {

std::string_view shader_head() {
  return "#version 330 core\n";
}

const char* shader_version() {
  return "#version 330 core";
}

bool has_needed_gl() {
  constexpr int kNeeded = 33;
  return epoxy_is_desktop_gl() && epoxy_gl_version() >= kNeeded;
}

bool has_gl_extension(const char* name) {
  return epoxy_has_gl_extension(name);
}

MaskFormat mask_format() {
  return {.internal = GL_R16, .format = GL_RED, .type = GL_UNSIGNED_SHORT, .channels = 1};
}

std::byte* map_to_write(std::size_t offset, std::size_t size) {
  return static_cast<std::byte*>(glMapBufferRange(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset),
                                                  static_cast<GLsizeiptr>(size), GL_MAP_WRITE_BIT));
}

// The memory is lost, for example, by a change of the video mode.
bool unmap_written() {
  return glUnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE;
}

void wait_for(GLsync fence) {
  glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
}

bool read_packed(std::span<std::uint8_t> to) {
  const void* const pixels =
      glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(to.size()), GL_MAP_READ_BIT);
  if (pixels == nullptr) return false;
  std::memcpy(to.data(), pixels, to.size());
  glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  return true;
}

}  // namespace mes::render

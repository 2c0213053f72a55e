// SPDX-License-Identifier: GPL-3.0-or-later
// The differences between OpenGL 3.3 and WebGL 2, in which browsers draw (web/render/device/gl_dialect.cpp).
//
// Threads: that of the context, which must be current.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace mes::render {

/// The first lines of every program.
std::string_view shader_head();
/// The version alone, for Dear ImGui, which adds the rest.
const char* shader_version();

/// False: the context is too old.
bool has_needed_gl();
bool has_gl_extension(const char* name);

/// A texture of numbers of 16 bits. `channels` is what composite.frag has to know.
struct MaskFormat {
  GLint internal;
  GLenum format;
  GLenum type;
  int channels;
};
MaskFormat mask_format();

/// Maps bytes of the buffer bound to GL_ARRAY_BUFFER for writing, until `unmap_written`; null if that is not supported.
std::byte* map_to_write(std::size_t offset, std::size_t size);
/// False: what was written is lost.
bool unmap_written();

/// Waits until the card has come to the fence.
void wait_for(GLsync fence);
/// Copies the buffer bound to GL_PIXEL_PACK_BUFFER. False: it has no memory.
bool read_packed(std::span<std::uint8_t> to);

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// Successive uniform blocks for draw calls, in one OpenGL buffer.
//
// Guarantees: a block that was bound keeps its contents until the draw calls that read it are done, and no call
// waits for drawing. Each block has its own slot in the buffer; when all slots are used, the driver allocates fresh
// memory and keeps the old memory while draw calls need it.
//
// Smallest use:
//     UniformRing ring;
//     ring.bind(kBindingPoint, uniforms);
//     glDrawArraysInstanced(...);
//
// Cost: `bind` copies the block, 144 bytes, unless it equals the bound one. Threads: the one that owns the context,
// which must be current.
#pragma once

#include <epoxy/gl.h>

#include <optional>

#include "render/device/draw_uniforms.h"
#include "render/device/gl_handles.h"

namespace mes::render {

class UniformRing {
 public:
  UniformRing();

  /// The next draw call reads `uniforms` at the binding point, which must have no other buffer.
  void bind(GLuint binding_point, const DrawUniforms& uniforms);

 private:
  GlBuffer buffer_;
  GLsizeiptr stride_ = 0;
  GLsizeiptr used_ = 0;  // bytes
  std::optional<GLuint> bound_to_;
  DrawUniforms bound_;
};

}  // namespace mes::render

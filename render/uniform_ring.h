// SPDX-License-Identifier: GPL-3.0-or-later
// Uniform blocks for draw calls, one after the other in one buffer of OpenGL.
//
// What it guarantees: a block that was bound keeps its contents until the draw calls that read it are done, and no call
// waits for drawing. Each block has a place of its own in the buffer; when all places are used, the driver is asked for
// fresh memory and keeps the old one as long as draw calls need it.
//
// Smallest use:
//     UniformRing ring;
//     ring.bind(kBindingPoint, uniforms);
//     glDrawArraysInstanced(...);
//
// Cost: `bind` copies the block, 144 bytes, unless it equals the one that is bound. Threads: the one that owns the context, which must be current.
#pragma once

#include <epoxy/gl.h>

#include <optional>

#include "render/draw_uniforms.h"
#include "render/gl_handles.h"

namespace mes::render {

class UniformRing {
 public:
  UniformRing();

  /// The next draw call reads `uniforms` at the binding point, to which nothing else is bound.
  void bind(GLuint binding_point, const DrawUniforms& uniforms);

 private:
  GlBuffer buffer_;
  GLsizeiptr stride_ = 0;
  GLsizeiptr used_ = 0;  // bytes
  std::optional<GLuint> bound_to_;
  DrawUniforms bound_;
};

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// Owners of OpenGL names. Their context must be current when they are destroyed.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace mes::render {

/// Calls `Release{}(name)` in its destructor, unless the name is zero. Move-only.
template <class Release>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  ~GlName() {
    if (name_ != 0) Release{}(name_);
  }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint get() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct ReleaseBuffer {
  void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct ReleaseTexture {
  void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct ReleaseRenderbuffer {
  void operator()(GLuint name) const { glDeleteRenderbuffers(1, &name); }
};
struct ReleaseFramebuffer {
  void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct ReleaseVertexArray {
  void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct ReleaseProgram {
  void operator()(GLuint name) const { glDeleteProgram(name); }
};
struct ReleaseShader {
  void operator()(GLuint name) const { glDeleteShader(name); }
};

using GlBuffer = GlName<ReleaseBuffer>;
using GlTexture = GlName<ReleaseTexture>;
using GlRenderbuffer = GlName<ReleaseRenderbuffer>;
using GlFramebuffer = GlName<ReleaseFramebuffer>;
using GlVertexArray = GlName<ReleaseVertexArray>;
using GlProgram = GlName<ReleaseProgram>;
using GlShader = GlName<ReleaseShader>;

}  // namespace mes::render

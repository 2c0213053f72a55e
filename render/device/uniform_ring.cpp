// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/uniform_ring.h"

#include <cstring>

namespace mes::render {
namespace {

constexpr GLsizeiptr kBlocks = 256;
constexpr auto kBlockSize = static_cast<GLsizeiptr>(sizeof(DrawUniforms));

}  // namespace

UniformRing::UniformRing() {
  GLint alignment = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  stride_ = (kBlockSize + alignment - 1) / alignment * alignment;
  used_ = kBlocks * stride_;
  GLuint name = 0;
  glGenBuffers(1, &name);
  buffer_ = GlBuffer(name);
}

void UniformRing::bind(GLuint binding_point, const DrawUniforms& uniforms) {
  // A driver may treat every newly bound block as a change, even if it holds the same values. A zero of opposite sign
  // binds once more, which does no harm.
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  if (bound_to_ == binding_point && std::memcmp(&bound_, &uniforms, sizeof uniforms) == 0) return;
  bound_to_ = binding_point;
  bound_ = uniforms;
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.get());
  if (used_ == kBlocks * stride_) {
    glBufferData(GL_UNIFORM_BUFFER, kBlocks * stride_, nullptr, GL_STREAM_DRAW);
    used_ = 0;
  }
  glBufferSubData(GL_UNIFORM_BUFFER, used_, kBlockSize, &uniforms);
  glBindBufferRange(GL_UNIFORM_BUFFER, binding_point, buffer_.get(), used_, kBlockSize);
  used_ += stride_;
}

}  // namespace mes::render

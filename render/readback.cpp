// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/readback.h"

#include <new>
#include <utility>

#include "render/device/gl_dialect.h"

namespace mes::render {

Readback::~Readback() {
  for (const Place& place : ring_)
    if (place.fence != nullptr) glDeleteSync(place.fence);
}

void Readback::ask(FramebufferId source, const PixelRect& area) {
  if (used_ == kPlaces) {
    come_.emplace_back();
    come_.back() = take_oldest();
  }
  Place& place = ring_[(first_ + used_) % kPlaces];
  const std::size_t bytes =
      std::size_t{4} * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
  if (place.buffer.get() == 0) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    place.buffer = GlBuffer(name);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, place.buffer.get());
  if (place.bytes != bytes) {
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
    place.bytes = bytes;
  }
  place.width = area.width;
  place.height = area.height;
  device_.bind_for_reading(source);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(area.left, area.bottom, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  place.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  // Otherwise the fence might stay in the driver's queue until a call waits for it.
  glFlush();
  ++used_;
}

// Frees the slot even after an error.
RawImage Readback::take_oldest() noexcept {
  Place& place = oldest();
  wait_for(place.fence);
  if (place.fence != nullptr) glDeleteSync(std::exchange(place.fence, nullptr));
  RawImage out{place.width, place.height, {}};
  glBindBuffer(GL_PIXEL_PACK_BUFFER, place.buffer.get());
  try {
    out.rgba.resize(place.bytes);
  } catch (const std::bad_alloc&) {
    out.rgba.clear();
  }
  if (!out.rgba.empty() && !read_packed(out.rgba)) {
    out.rgba.clear();
    place.bytes = 0;  // the card may have lacked memory for the buffer
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  first_ = (first_ + 1) % kPlaces;
  --used_;
  return out;
}

std::optional<RawImage> Readback::poll() {
  if (come_.empty() && used_ != 0) {
    const GLenum state = glClientWaitSync(oldest().fence, 0, 0);
    if (state == GL_TIMEOUT_EXPIRED) return std::nullopt;
  }
  return wait();
}

std::optional<RawImage> Readback::wait() {
  if (!come_.empty()) {
    RawImage out = std::move(come_.front());
    come_.pop_front();
    return out;
  }
  if (used_ == 0) return std::nullopt;
  return take_oldest();
}

}  // namespace mes::render

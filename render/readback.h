// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pixels from the graphics card while it continues drawing.
//
// Guarantees:
//  1. `ask` copies the contents of the target at that moment; later drawing does not change the picture.
//  2. Pictures are returned in the order in which they were requested, each once.
//  3. `ask` waits only if kPlaces pictures are already in flight; no picture is dropped. If it throws for lack of
//     memory, nothing was requested.
//  4. If memory runs out after the request, the picture is still returned in order, without pixels.
//
// Smallest use:
//     Readback readback(device);
//     readback.ask(target, {0, 0, 1920, 1080});
//     ... in a later frame: while (auto raw = readback.poll()) use(*raw);
//
// Cost: `ask` starts a copy on the card; a picture that has arrived is copied once more, 4 bytes a pixel.
// Threads: the one that owns the context, which must be current as long as the object exists.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>

#include "render/device/gl_device.h"
#include "render/device/gl_handles.h"
#include "render/image/image.h"

namespace mes::render {

class Readback {
 public:
  static constexpr std::size_t kPlaces = 3;

  explicit Readback(GlDevice& device) : device_(device) {}
  ~Readback();
  Readback(const Readback&) = delete;
  Readback& operator=(const Readback&) = delete;

  void ask(FramebufferId source, const PixelRect& area);
  /// The oldest picture, if it has arrived.
  std::optional<RawImage> poll();
  /// The oldest picture; waits for it. None if no picture was requested.
  std::optional<RawImage> wait();
  std::size_t pending() const { return come_.size() + used_; }

 private:
  struct Place {
    GlBuffer buffer;
    std::size_t bytes = 0;
    int width = 0;
    int height = 0;
    GLsync fence = nullptr;
  };
  Place& oldest() { return ring_[first_]; }
  RawImage take_oldest() noexcept;

  GlDevice& device_;
  std::array<Place, kPlaces> ring_{};
  std::size_t first_ = 0;  // the oldest picture in flight
  std::size_t used_ = 0;
  std::deque<RawImage> come_;  // arrived, and taken early to free a slot
};

}  // namespace mes::render

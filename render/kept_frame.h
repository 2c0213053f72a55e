// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the last complete drawing of a window on the graphics card while the next one is made, to show it again: as it
// is, or as another camera would see it.
#pragma once

#include "render/camera.h"
#include "render/device/convert.h"
#include "render/device/gl_device.h"

namespace mes::render {

/// Guarantees: `show` copies exactly the pixels that were kept. Cost: one copy of the picture each, on the graphics
/// card. Needs the OpenGL context of its device for its life. Threads: that of the context.
class KeptFrame {
 public:
  explicit KeptFrame(GlDevice& device) : device_(device) {}
  ~KeptFrame();
  KeptFrame(const KeptFrame&) = delete;
  KeptFrame& operator=(const KeptFrame&) = delete;

  /// A target for the next drawing; the kept one stays.
  FramebufferId begin(int width, int height);
  /// The drawing that was begun is complete, and is kept instead of the last one.
  void keep();
  /// Whether a drawing of this size is kept.
  bool has(int width, int height) const { return kept_.is_of(width, height); }

  /// Copies the kept drawing to a target of its size, such as the window.
  void show(FramebufferId target = {}) const { copy(kept_, target); }
  /// Copies the drawing that was begun, as far as it is drawn.
  void show_begun(FramebufferId target = {}) const { copy(begun_, target); }
  /// Copies a part of the kept drawing, `area`, which camera `was` saw, to its position for camera `now`. The rest of
  /// the area has the colour.
  void show_moved(const PixelRect& area, const Camera& was, const Camera& now, const PremultipliedColor& color,
                  FramebufferId target = {}) const;

 private:
  struct Frame {
    FramebufferId id{};
    int width = 0;
    int height = 0;
    bool is_of(int w, int h) const { return id != FramebufferId{} && width == w && height == h; }
  };
  void copy(const Frame& frame, FramebufferId target) const;

  GlDevice& device_;
  Frame kept_;
  Frame begun_;
};

}  // namespace mes::render

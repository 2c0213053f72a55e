// SPDX-License-Identifier: GPL-3.0-or-later
// What was drawn to the window, kept on the graphics card to be shown again.
#pragma once

#include "render/gl_handles.h"

namespace mes::render {

/// What it guarantees: `show` draws what the last `keep` read, to the pixel. Cost: one copy of the picture each, on
/// the graphics card. Needs a current OpenGL context for its life. Threads: that of the context.
class KeptFrame {
 public:
  /// Reads the lower left `width` by `height` pixels of the window, before they are swapped.
  void keep(int width, int height);
  /// Draws them to the window again; `keep` has been called with this size.
  void show(int width, int height) const;

 private:
  void make();

  GlTexture texture_;
  GlFramebuffer reader_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the last content of the window on the graphics card, to show it again.
#pragma once

#include "render/gl_handles.h"

namespace mes::render {

/// Guarantees: `show` draws exactly the pixels that the last `keep` read. Cost: one copy of the picture each,
/// on the graphics card. Needs a current OpenGL context for its life. Threads: that of the context.
class KeptFrame {
 public:
  /// Reads the lower left `width` by `height` pixels of the window, before they are swapped.
  void keep(int width, int height);
  /// Draws them to the window again; the last `keep` must have had this size.
  void show(int width, int height) const;

 private:
  void make();

  GlTexture texture_;
  GlFramebuffer reader_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that a frame shows, and its camera.
#pragma once

#include "app/panes/view_motion.h"
#include "app/settings/record_settings.h"
#include "render/camera.h"

namespace mes {

/// A part of a window, in pixels from its upper left corner.
struct WindowPart {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const WindowPart&, const WindowPart&) = default;
};
/// The area that the panels leave free; the whole window if that is hardly anything.
WindowPart part_between(const Insets& panels, int width, int height);

/// The picture's view of a window's view: the whole part around the same middle, with lines and points enlarged like
/// the rest.
struct FrameView {
  render::Camera camera;
  double content_scale = 1.0;
};
FrameView frame_view(const render::Camera& window, const WindowPart& part, double content_scale,
                     const RecordSettings& settings);

}  // namespace mes

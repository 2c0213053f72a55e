// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the plane: its centre, its scale, and its size in pixels.
//
// Guarantees:
//  1. Every result is finite: arguments that are not finite are ignored, all others are clamped.
//  2. `zoom_at` keeps the world point under the cursor fixed, to a small fraction of a pixel, at every scale.
//  3. Moving by n pixels and back by n pixels shows the same picture: the centre has twice the bits of a double, so
//     the view does not jump between representable numbers, neither in deep zoom nor at coordinate 10^15.
//
// Smallest use:
//     Camera camera;
//     camera.set_viewport(1600, 1000);
//     camera.fit(box, 40.0);
//     camera.zoom_at(cursor, 1.1);
//
// Screen coordinates are framebuffer pixels from the upper left corner of the view, y down; the world has y up.
// Cost: a few operations a call. Threads: a value; const calls may run at the same time.
#pragma once

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"

namespace mes::render {

class Camera {
 public:
  /// In pixels, clamped to at least 1. Centre and scale do not change.
  void set_viewport(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  Vec2 center() const { return center_; }
  /// The part of the centre that `center()` cannot represent: the exact centre is the sum of both.
  Vec2 center_low() const { return center_low_; }
  double units_per_pixel() const { return units_per_pixel_; }
  void look_at(Vec2 center, double units_per_pixel);

  Vec2 to_screen(Vec2 world) const;
  Vec2 to_world(Vec2 screen) const;
  /// The part of the plane that the view shows.
  Box2 visible() const;

  /// A `factor` above 1 magnifies. The world point under `screen` stays there.
  void zoom_at(Vec2 screen, double factor);
  /// Moves the picture by `delta` pixels, as dragging does.
  void pan(Vec2 delta);
  /// Shows the whole box with a margin of `margin_px` pixels. For an empty box it shows the unit square; a box without
  /// extent is shown at the scale of its coordinates.
  void fit(const Box2& box, double margin_px);

  /// The camera of a part of this view: `width` x `height` pixels, the upper left one at (`left`, `top`).
  Camera part(int left, int top, int width, int height) const;

  friend bool operator==(const Camera&, const Camera&) = default;

 private:
  void move_center(Vec2 delta);
  void clamp();

  Vec2 center_{};
  Vec2 center_low_{};
  double units_per_pixel_ = 0.01;
  int width_ = 1;
  int height_ = 1;
};

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
// Where the plane is looked at from: a centre, a scale, and the size of the view.
//
// What it guarantees:
//  1. Everything it returns is finite, whatever it is told: arguments that are not finite are ignored, the others are
//     clamped.
//  2. `zoom_at` keeps the world point under the cursor where it is, to a small fraction of a pixel, at every scale.
//  3. Moving by n pixels and back by n pixels shows the same picture: the centre carries twice the bits of a double,
//     so neither deep zoom nor a drawing at coordinate 10^15 makes the view jump between representable numbers.
//
// Smallest use:
//     Camera camera;
//     camera.set_viewport(1600, 1000);
//     camera.fit(box, 40.0);
//     camera.zoom_at(cursor, 1.1);
//
// Screen coordinates are framebuffer pixels from the upper left corner of the view, y down; the world has y up.
// Cost: a few operations each. Threads: a value.
#pragma once

#include "core/base/box2.h"
#include "core/base/vec2.h"

namespace mes::render {

class Camera {
 public:
  /// Pixels; at least 1 each. Centre and scale stay.
  void set_viewport(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  Vec2 center() const { return center_; }
  /// What the centre is beyond `center()`: the exact centre is the sum of both.
  Vec2 center_low() const { return center_low_; }
  double units_per_pixel() const { return units_per_pixel_; }
  void look_at(Vec2 center, double units_per_pixel);

  Vec2 to_screen(Vec2 world) const;
  Vec2 to_world(Vec2 screen) const;
  /// Part of the plane that is seen.
  Box2 visible() const;

  /// `factor` above 1 magnifies. The world point under `screen` stays there.
  void zoom_at(Vec2 screen, double factor);
  /// The picture moves by `delta` pixels, as if dragged.
  void pan(Vec2 delta);
  /// Shows the whole box with `margin_px` around it. An empty box shows the unit square, a box of no extent is shown
  /// at the scale of its coordinates.
  void fit(const Box2& box, double margin_px);

  /// The camera of a part of this view, `width` x `height` pixels whose upper left one is (`left`, `top`).
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

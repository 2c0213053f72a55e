// SPDX-License-Identifier: GPL-3.0-or-later
// Draws lines and circles of the plane over a part of it, clipped to its neighbourhood.
//
// Cost: microseconds per shape. Threads: any, with a drawing of its own.
#pragma once

#include "app/picture/paper/paper_drawing.h"
#include "app/picture/paper/scale_drawing.h"
#include "core/base/geometry/box2.h"

namespace mes {

/// Guarantees: whatever numbers a shape has, its drawing lies within a width and a height around the part of the
/// plane, and deviates by at most a tenth of a logical pixel. Lengths are in logical pixels, y down.
class PlaneDrawing {
 public:
  /// Both arguments must outlive it.
  PlaneDrawing(PaperDrawing& drawing, const SeenPlane& plane);

  Vec2 on_paper(Vec2 world) const;
  double on_paper(double length) const { return length / plane_.units_per_pixel; }
  bool reaches(Vec2 p) const;

  void segment(Vec2 from, Vec2 to, double width, Rgb color) { line(from, to - from, 0.0, 1.0, width, color); }
  /// Draws the points at + t * way for t from `low` to `high`, which may be infinite.
  void line(Vec2 at, Vec2 way, double low, double high, double width, Rgb color);
  void circle(Vec2 center, double radius, double width, Rgb color);
  /// Draws an arc from `from` on by `sweep`, clockwise on the drawing, as in `PaperDrawing::Arc`.
  void arc(Vec2 center, double radius, double from, double sweep, double width, Rgb color);

 private:
  PaperDrawing& drawing_;
  const SeenPlane& plane_;
  Box2 reach_;
};

}  // namespace mes

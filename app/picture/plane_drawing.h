// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and circles of the plane on a drawing over a part of it, cut where they leave its neighbourhood.
//
// Cost: microseconds a shape. Threads: any, with a drawing of its own.
#pragma once

#include "app/picture/paper_drawing.h"
#include "app/picture/scale_drawing.h"
#include "core/base/box2.h"

namespace mes {

/// What it guarantees: whatever numbers a shape has, what is drawn lies within a width and a height around the part of
/// the plane, and is nowhere more than a tenth of a logical pixel off. Lengths are in logical pixels, y down.
class PlaneDrawing {
 public:
  /// Both outlive it.
  PlaneDrawing(PaperDrawing& drawing, const SeenPlane& plane);

  Vec2 on_paper(Vec2 world) const;
  double on_paper(double length) const { return length / plane_.units_per_pixel; }
  bool reaches(Vec2 p) const;

  void segment(Vec2 from, Vec2 to, double width, Rgb color) { line(from, to - from, 0.0, 1.0, width, color); }
  /// The places at + t * way for t from `low` to `high`, which may be infinite.
  void line(Vec2 at, Vec2 way, double low, double high, double width, Rgb color);
  void circle(Vec2 center, double radius, double width, Rgb color);
  /// From `from` on by `sweep`, clockwise as seen, as `PaperDrawing::Arc`.
  void arc(Vec2 center, double radius, double from, double sweep, double width, Rgb color);

 private:
  PaperDrawing& drawing_;
  const SeenPlane& plane_;
  Box2 reach_;
};

}  // namespace mes

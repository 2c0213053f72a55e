// SPDX-License-Identifier: GPL-3.0-or-later
// Draws single shapes of the document over the picture, behind all panels.
#pragma once

#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/ui/screen/gui.h"
#include "core/base/geometry/arc.h"
#include "core/base/geometry/parabola_arc.h"
#include "core/draw/provenance.h"

namespace mes {

/// The mark of a point; each can be distinguished from the others without colours.
enum class PenMark : std::uint8_t { dot, ring, square };

struct PenLook {
  ImU32 color = 0;
  float width = 1.0F;  ///< width of lines, in screen coordinates
  PenMark mark = PenMark::dot;
};

/// Guarantees: shapes are clipped to the window before they are rounded to single precision. Areas are drawn as
/// outlines. Lives for one frame.
class ShapePen {
 public:
  /// `content_scale`: framebuffer pixels per logical pixel.
  ShapePen(const Gui& gui, const PanePart& pane, double content_scale, const PenLook& look);

  void draw(const ProvenanceShape& shape) const;

 private:
  Vec2 on_screen(Vec2 world) const;
  void point(Vec2 world) const;
  void circle(Vec2 center, double radius) const;
  void arc(const Arc& arc) const;
  void parabola(const ParabolaArc& arc) const;
  void line(Vec2 a, Vec2 b) const;
  void unbounded(Vec2 a, Vec2 d, double low) const;

  const render::Camera& camera_;
  Vec2 shift_;
  float unit_;
  double to_screen_;  ///< screen coordinates per framebuffer pixel
  PenLook look_;
  Vec2 size_;
  ImDrawList& list_;
};

}  // namespace mes

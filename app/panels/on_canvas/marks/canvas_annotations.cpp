// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/canvas_annotations.h"

#include "app/panels/on_canvas/marks/paper_on_canvas.h"
#include "app/ui/screen/theme.h"

namespace mes {

AnnotationDrawing CanvasAnnotations::layout() const {
  return layout_annotations(place(document), seen_plane(pane.camera, content_scale), measure_on_canvas(gui),
                            background);
}

void CanvasAnnotations::draw(const AnnotationDrawing& drawn) const {
  paint_on_canvas(gui, drawn.highlights, pane.shift);
  paint_on_canvas(gui, drawn.drawing, pane.shift);
}

void CanvasAnnotations::draw_frames(const AnnotationDrawing& drawn, std::optional<std::size_t> pointed_at) const {
  const float unit = gui.unit();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto frame = [&](std::size_t i, float width) {
    if (i >= drawn.words.size() || drawn.words[i].is_empty()) return;
    const auto corner = [&](Vec2 p, float out) {
      return ImVec2(pane.shift.x + (static_cast<float>(p.x) + out) * unit,
                    pane.shift.y + (static_cast<float>(p.y) + out) * unit);
    };
    constexpr float kMargin = 4.0F;
    list.AddRect(corner(drawn.words[i].low, -kMargin), corner(drawn.words[i].high, kMargin), gui.colors().accent,
                 3.0F * unit, 0, width * unit);
  };
  if (pointed_at) frame(*pointed_at, 1.0F);
  if (annotations.current() != nullptr && annotations.selected()) frame(*annotations.selected(), 2.0F);
}

}  // namespace mes

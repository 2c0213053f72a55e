// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/paper_on_canvas.h"

#include <cfloat>

#include "app/ui/screen/theme.h"

namespace mes {
namespace {

ImFont* font_of(const Gui& gui, Face face, double size) {
  switch (face) {
    case Face::plain: return gui.letters(Gui::Look::plain, size);
    case Face::bold: return gui.letters(Gui::Look::bold, size);
    case Face::italic: return gui.letters(Gui::Look::italic, size);
  }
  return ImGui::GetFont();
}

}  // namespace

MeasureText measure_on_canvas(const Gui& gui) {
  return [&gui](const std::string& text, double size, Face face) {
    const float unit = gui.unit();
    const ImVec2 extent =
        font_of(gui, face, size)->CalcTextSizeA(static_cast<float>(size) * unit, FLT_MAX, 0.0F, text.c_str());
    return static_cast<double>(extent.x / unit);
  };
}

void paint_on_canvas(const Gui& gui, const PaperDrawing& drawing, ImVec2 corner) {
  paint(*ImGui::GetBackgroundDrawList(), gui, drawing, corner);
}

void paint(ImDrawList& list, const Gui& gui, const PaperDrawing& drawing, ImVec2 corner) {
  const float unit = gui.unit();
  const glm::mat3 place_of(paper_placement({corner.x, corner.y}, static_cast<double>(unit)));
  const auto place = [&](double x, double y) {
    const glm::vec3 out = place_of * glm::vec3(x, y, 1.0);
    return ImVec2(out.x, out.y);
  };
  for (const PaperDrawing::Box& box : drawing.boxes) {
    list.AddRectFilled(place(box.left, box.top), place(box.left + box.width, box.top + box.height),
                       to_imgui(box.color, box.opacity));
  }
  const auto add_points = [&](std::span<const Vec2> points) {
    for (const Vec2 p : points) list.PathLineTo(place(p.x, p.y));
  };
  for (const PaperDrawing::Stroke& stroke : drawing.strokes) {
    add_points(stroke.points);
    list.PathStroke(to_imgui(stroke.color), ImDrawFlags_None, static_cast<float>(stroke.width) * unit);
  }
  for (const PaperDrawing::Arc& arc : drawing.arcs) {
    const auto from = static_cast<float>(arc.from);
    list.PathArcTo(place(arc.center.x, arc.center.y), static_cast<float>(arc.radius) * unit, from,
                   from + static_cast<float>(arc.sweep));
    list.PathStroke(to_imgui(arc.color), ImDrawFlags_None, static_cast<float>(arc.width) * unit);
  }
  for (const PaperDrawing::Triangle& triangle : drawing.triangles) {
    add_points(triangle.corners);
    list.PathFillConvex(to_imgui(triangle.color));
  }
  for (const PaperDrawing::Dot& dot : drawing.dots)
    list.AddCircleFilled(place(dot.x, dot.y), static_cast<float>(dot.radius) * unit, to_imgui(dot.color));
  for (const PaperDrawing::Line& line : drawing.lines)
    list.AddText(font_of(gui, line.face, line.size), static_cast<float>(line.size) * unit, place(line.x, line.top),
                 to_imgui(line.color), line.text.c_str());
}

}  // namespace mes

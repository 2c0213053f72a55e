// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/paper_on_canvas.h"

#include <cfloat>

#include "app/ui/theme.h"

namespace mes {
namespace {

ImFont* font_of(const Gui& gui, bool is_bold) {
  return is_bold ? gui.bold() : ImGui::GetFont();
}

}  // namespace

MeasureText measure_on_canvas(const Gui& gui) {
  return [&gui](const std::string& text, double size, bool is_bold) {
    const float unit = gui.unit();
    const ImVec2 extent =
        font_of(gui, is_bold)->CalcTextSizeA(static_cast<float>(size) * unit, FLT_MAX, 0.0F, text.c_str());
    return static_cast<double>(extent.x / unit);
  };
}

void paint_on_canvas(const Gui& gui, const PaperDrawing& drawing, ImVec2 corner) {
  const float unit = gui.unit();
  const glm::mat3 place_of(paper_placement({corner.x, corner.y}, static_cast<double>(unit)));
  const auto place = [&](double x, double y) {
    const glm::vec3 out = place_of * glm::vec3(x, y, 1.0);
    return ImVec2(out.x, out.y);
  };
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const PaperDrawing::Box& box : drawing.boxes) {
    list.AddRectFilled(place(box.left, box.top), place(box.left + box.width, box.top + box.height),
                       to_imgui(box.color, box.opacity));
  }
  for (const PaperDrawing::Dot& dot : drawing.dots)
    list.AddCircleFilled(place(dot.x, dot.y), static_cast<float>(dot.radius) * unit, to_imgui(dot.color));
  for (const PaperDrawing::Line& line : drawing.lines)
    list.AddText(font_of(gui, line.is_bold), static_cast<float>(line.size) * unit, place(line.x, line.top),
                 to_imgui(line.color), line.text.c_str());
}

}  // namespace mes

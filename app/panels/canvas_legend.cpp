// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/canvas_legend.h"

#include <cfloat>
#include <cmath>

#include "app/model/scalar_words.h"
#include "app/picture/legend.h"
#include "app/ui/theme.h"

namespace mes {

ImVec2 CanvasLegend::draw(ImVec2 corner, float room) const {
  std::vector<LegendEntry> entries = picture.legend(layers);
  if (entries.empty()) return {};
  for (LegendEntry& entry : entries) entry.scalar = spoken_scalar(entry.scalar);
  const float unit = gui.unit();
  const auto font = [&](bool is_bold) { return is_bold ? gui.bold() : ImGui::GetFont(); };
  const MeasureText measure = [&](const std::string& text, double size, bool is_bold) {
    const ImVec2 extent = font(is_bold)->CalcTextSizeA(static_cast<float>(size) * unit, FLT_MAX, 0.0F, text.c_str());
    return static_cast<double>(extent.x / unit);
  };
  const LegendDrawing legend = layout_legend(entries, measure, static_cast<double>(room / unit), picture.canvas());
  const ImVec2 at(std::floor(corner.x - static_cast<float>(legend.width) * unit),
                  std::floor(corner.y - static_cast<float>(legend.height) * unit));
  const glm::mat3 place_of(legend_placement({at.x, at.y}, static_cast<double>(unit)));
  const auto place = [&](double x, double y) {
    const glm::vec3 out = place_of * glm::vec3(x, y, 1.0);
    return ImVec2(out.x, out.y);
  };
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const LegendDrawing::Box& box : legend.boxes) {
    list.AddRectFilled(place(box.left, box.top), place(box.left + box.width, box.top + box.height),
                       to_imgui(box.color, box.opacity));
  }
  for (const LegendDrawing::Line& line : legend.lines)
    list.AddText(font(line.is_bold), static_cast<float>(line.size) * unit, place(line.x, line.top),
                 to_imgui(line.color), line.text.c_str());
  return {static_cast<float>(legend.width) * unit, static_cast<float>(legend.height) * unit};
}

}  // namespace mes

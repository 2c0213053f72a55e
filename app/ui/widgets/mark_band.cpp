// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/mark_band.h"

#include <cmath>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr float kReach = 4.0F;  // logical pixels

}  // namespace

MarkBand::MarkBand(const Gui& gui, const char* id, float width, float height)
    : gui_(gui),
      at_(ImGui::GetCursorScreenPos()),
      size_(width, height),
      is_clicked_(hit_area(id, size_)),
      is_hovered_(ImGui::IsItemHovered()),
      nearest_(kReach * gui.unit()) {
  ImGui::GetWindowDrawList()->AddRectFilled(at_, {at_.x + size_.x, at_.y + size_.y},
                                            ImGui::GetColorU32(ImGuiCol_FrameBg), 2 * gui.unit());
}

bool MarkBand::mark(float x, Rgb color, float thickness) {
  ImGui::GetWindowDrawList()->AddLine({x, at_.y}, {x, at_.y + size_.y}, to_imgui(color), thickness * gui_.unit());
  const float away = std::abs(x - ImGui::GetIO().MousePos.x);
  if (!is_hovered_ || away > nearest_) return false;
  nearest_ = away;
  return true;
}

void MarkBand::show_value(float x) const {
  const float unit = gui_.unit();
  ImGui::GetWindowDrawList()->AddTriangleFilled({x - 4 * unit, at_.y}, {x + 4 * unit, at_.y}, {x, at_.y + 6 * unit},
                                                gui_.colors().text);
}

void MarkBand::explain(const std::string& words) const {
  tooltip(gui_, words);
}

}  // namespace mes

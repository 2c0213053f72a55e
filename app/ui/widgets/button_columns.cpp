// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/button_columns.h"

#include <algorithm>
#include <cmath>

namespace mes {

float column_button_size(std::size_t buttons, std::size_t lines, float room) {
  constexpr float kLargest = 34.0F;
  constexpr float kSmallInOne = 28.0F;
  constexpr float kSmallest = 24.0F;
  constexpr float kLine = 4 * kButtonGap;  // height of a line, including its surroundings
  const auto count = static_cast<float>(buttons);
  const auto between = static_cast<float>(lines);
  const float in_one = (room - between * kLine) / count - kButtonGap;
  if (in_one >= kSmallInOne) return std::min(in_one, kLargest);
  return std::clamp((room - (between - 1) * kLine) / std::ceil(0.5F * count) - kButtonGap, kSmallest, kLargest);
}

bool ButtonColumns::advance(bool begins_group) {
  const float line = begins_group && end_ > 0.0F ? 4 * gap_ : 0.0F;
  const bool is_full = end_ > 0.0F && end_ + line + size_ > room_;
  if (is_full) x_ += size_ + gap_;
  y_ = is_full ? 0.0F : end_ + line;
  end_ = y_ + size_ + gap_;
  return !is_full && line > 0.0F;
}

void ButtonColumns::next(bool begins_group) {
  if (advance(begins_group)) {
    const ImVec2 window = ImGui::GetWindowPos();
    const float at = window.y + origin_.y + y_ - 2.5F * gap_;
    const float left = window.x + origin_.x + x_;
    ImGui::GetWindowDrawList()->AddLine({left, at}, {left + size_, at}, ImGui::GetColorU32(ImGuiCol_Separator),
                                        std::max(1.0F, 0.5F * gap_));
  }
  ImGui::SetCursorPos({origin_.x + x_, origin_.y + y_});
}

}  // namespace mes

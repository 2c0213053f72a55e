// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/button_rows.h"

#include <algorithm>

#include "app/ui/widgets/widgets.h"

namespace mes {

ButtonRows::ButtonRows(const Gui& gui, std::span<const char* const> labels, float room, float wanted)
    : gui_(gui), labels_(labels) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float gap = style.ItemSpacing.x;
  float least = wanted;
  for (const char* label : labels) least = std::max(least, ImGui::CalcTextSize(label).x + 2 * style.FramePadding.x);
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, (room + gap) / (least + gap)));
  in_row_ = std::min(fitting, labels.size());
  button_ = wanted > 0.0F ? least : (room + gap) / static_cast<float>(in_row_) - gap;
}

float ButtonRows::height() const {
  const std::size_t rows = (labels_.size() + in_row_ - 1) / in_row_;
  return static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing();
}

float ButtonRows::width() const {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  return static_cast<float>(in_row_) * (button_ + gap) - gap;
}

bool ButtonRows::next(bool is_default) {
  if (drawn_ % in_row_ != 0) ImGui::SameLine();
  return default_button(gui_, labels_[drawn_++], {button_, 0}, is_default);
}

}  // namespace mes

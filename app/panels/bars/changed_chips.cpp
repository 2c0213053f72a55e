// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/changed_chips.h"

#include <fmt/core.h>

#include "app/layers/words/parameter_words.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

// Sizes in logical pixels.
constexpr float kChipGap = 6;
constexpr float kGapAfter = 16;
constexpr float kChipPadding = 7;
constexpr float kCross = 13;

std::string chip_explanation(const Parameter& parameter) {
  return spoken_explanation(parameter) + "\n\nClick: back to the default, " +
         value_text(parameter, parameter.default_value);
}

}  // namespace

ChangedChips::ChangedChips(const Gui& gui, ComputationControl& computation, Messages& messages)
    : gui_(gui),
      computation_(computation),
      messages_(messages),
      changed_(changed_parameters(computation.parameters(), computation.settings())) {
  for (const ChangedParameter& changed : changed_)
    widths_.push_back(text_width(changed.text) + (kCross + 2) * gui_.unit());
}

float ChangedChips::text_width(const std::string& text) const {
  const ImFont& font = *gui_.small();
  const float size = font.FontSize * ImGui::GetIO().FontGlobalScale;
  return font.CalcTextSizeA(size, 1e9F, 0.0F, text.c_str()).x + 2 * kChipPadding * gui_.unit();
}

std::string ChangedChips::rest_text(std::size_t shown) const {
  return fmt::format("+{}", changed_.size() - shown);
}

float ChangedChips::row_width(std::size_t shown) const {
  const float unit = gui_.unit();
  float out = kGapAfter * unit;
  for (std::size_t i = 0; i < shown; ++i) out += widths_[i] + (i == 0 ? 0.0F : kChipGap * unit);
  if (shown < changed_.size()) out += (shown == 0 ? 0.0F : kChipGap * unit) + text_width(rest_text(shown));
  return out;
}

std::size_t ChangedChips::shown_in(float room) const {
  const float unit = gui_.unit();
  return how_many_fit(widths_, kChipGap * unit, text_width(rest_text(0)), room - kGapAfter * unit);
}

float ChangedChips::full_width() const {
  return is_empty() ? 0.0F : row_width(changed_.size());
}

float ChangedChips::width_in(float room) const {
  return is_empty() ? 0.0F : row_width(shown_in(room));
}

void ChangedChips::reset(const Parameter& parameter) const {
  ParameterAnimation& animation = computation_.animation();
  if (animation.is_running() && animation.parameter == parameter) animation.stop();
  computation_.set(parameter, parameter.default_value);
  messages_.remark(title_of(parameter) + ": " + value_text(parameter, parameter.default_value) + " again");
}

bool ChangedChips::draw_chip(const char* id, const std::string& text, bool has_cross) const {
  const float unit = gui_.unit();
  const ThemeColors& colors = gui_.colors();
  const ImVec2 size(text_width(text) + (has_cross ? (kCross + 2) * unit : 0.0F), ImGui::GetFrameHeight());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool is_clicked = hit_area(id, size);
  const bool is_hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  list.AddRectFilled(at, end, is_hovered ? colors.accent_soft : colors.accent_faint, 0.5F * size.y);
  list.AddRect(at, end, colors.accent, 0.5F * size.y, 0, unit);
  ImFont* const font = gui_.small();
  const float height = font->FontSize * ImGui::GetIO().FontGlobalScale;
  list.AddText(font, height, {at.x + kChipPadding * unit, at.y + 0.5F * (size.y - height)}, colors.text,
               text.c_str());
  if (has_cross)
    draw_icon(list, Icon::close, {end.x - (kCross + 5) * unit, at.y + 0.5F * (size.y - kCross * unit)}, kCross * unit,
              is_hovered ? colors.text : colors.text_quiet);
  return is_clicked;
}

void ChangedChips::draw_rest(std::size_t shown) const {
  const float unit = gui_.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (draw_chip("rest", rest_text(shown), false)) ImGui::OpenPopup("##changed");
  tooltip(gui_, "More parameters that are not at their defaults");
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 8 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 7 * unit});
  // The popup opens above the bar, towards the middle of the window.
  const bool is_right = at.x > 0.5F * ImGui::GetIO().DisplaySize.x;
  ImGui::SetNextWindowPos({at.x, at.y - 9 * unit}, ImGuiCond_Appearing, {is_right ? 1.0F : 0.0F, 1.0F});
  if (begin_popup(gui_, "##changed")) {
    for (std::size_t i = shown; i < changed_.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (draw_chip("chip", changed_[i].text, true)) reset(changed_[i].parameter);
      tooltip(gui_, chip_explanation(changed_[i].parameter));
      ImGui::PopID();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void ChangedChips::draw(float room) const {
  if (is_empty()) return;
  const float unit = gui_.unit();
  const std::size_t shown = shown_in(room);
  ImGui::PushID("chips");
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) ImGui::SameLine(0, kChipGap * unit);
    ImGui::PushID(changed_[i].parameter.id.c_str());
    if (draw_chip("chip", changed_[i].text, true)) reset(changed_[i].parameter);
    tooltip(gui_, chip_explanation(changed_[i].parameter));
    ImGui::PopID();
  }
  if (shown < changed_.size()) {
    if (shown > 0) ImGui::SameLine(0, kChipGap * unit);
    draw_rest(shown);
  }
  ImGui::PopID();
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/question.h"

#include <algorithm>
#include <utility>

#include "app/ui/widgets/button_rows.h"
#include "app/ui/widgets/paragraph.h"

namespace mes {

void Question::press(const KeyChord& chord) {
  switch (chord.symbol) {
    case key::enter: is_confirmed_ = true; return;
    case key::left: --steps_; return;
    case key::right: ++steps_; return;
    case key::tab: steps_ += chord.modifiers.shift ? -1 : 1; return;
    default: return;
  }
}

std::optional<std::size_t> Question::draw_question(const Gui& gui, const char* id,
                                                   std::span<const char* const> answers, std::size_t usual,
                                                   const std::string& heading,
                                                   const std::function<void(float width)>& draw_rest) {
  const bool is_confirmed = std::exchange(is_confirmed_, false);
  if (!is_open()) steps_ = 0;
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  std::optional<std::size_t> out;
  if (Gui::begin_dialog(id, is_open(), ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    const float edge = 12 * unit;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const float most = screen.x - 2 * (edge + padding.x);
    ButtonRows buttons(gui, answers, most, 120 * unit);
    // File names may be long.
    const float width = std::min(most, std::max(0.6F * screen.x, buttons.width()));
    const float room = screen.y - 2 * (edge + padding.y) - buttons.height();
    const bool is_scrolled = body_ > room;
    if (is_scrolled) ImGui::BeginChild("body", {width, room});
    const float inner = is_scrolled ? width - ImGui::GetStyle().ScrollbarSize : width;
    ImGui::BeginGroup();
    ImGui::PushFont(gui.bold());
    paragraph(heading, inner);
    ImGui::PopFont();
    draw_rest(inner);
    ImGui::Dummy({1, 6 * unit});
    ImGui::EndGroup();
    body_ = ImGui::GetItemRectSize().y;
    if (is_scrolled) ImGui::EndChild();
    const auto count = static_cast<std::ptrdiff_t>(answers.size());
    const auto chosen =
        static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(usual) + steps_) % count + count) % count);
    for (std::size_t i = 0; i < answers.size(); ++i)
      if (buttons.next(i == chosen)) out = i;
    if (is_confirmed && !out) out = chosen;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return out;
}

}  // namespace mes

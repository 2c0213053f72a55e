// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/question.h"

#include <utility>

#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

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
    // File names may be long.
    const float width = 0.6F * screen.x;
    ImGui::PushFont(gui.bold());
    paragraph(heading, width);
    ImGui::PopFont();
    draw_rest(width);
    ImGui::Dummy({1, 6 * unit});
    const auto count = static_cast<std::ptrdiff_t>(answers.size());
    const auto chosen =
        static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(usual) + steps_) % count + count) % count);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (i != 0) ImGui::SameLine();
      if (default_button(gui, answers[i], {120 * unit, 0}, i == chosen)) out = i;
    }
    if (is_confirmed && !out) out = chosen;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return out;
}

}  // namespace mes

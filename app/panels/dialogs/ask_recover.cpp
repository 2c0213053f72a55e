// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/ask_recover.h"

#include <fmt/core.h>

namespace mes {

std::optional<LeftWork> AskRecover::take() {
  if (works_.empty()) return std::nullopt;
  LeftWork out = std::move(works_.front());
  works_.erase(works_.begin());
  return out;
}

void AskRecover::offer(std::vector<LeftWork> works, std::function<void()> recover) {
  works_ = std::move(works);
  recover_ = std::move(recover);
}

void AskRecover::draw(const Gui& gui) {
  switch (draw_question(gui)) {
    case Pressed::none: break;
    case Pressed::later: cancel(); break;
    case Pressed::discard:
      if (auto work = take()) work->remove();
      break;
    case Pressed::recover: recover_(); break;
  }
}

AskRecover::Pressed AskRecover::draw_question(const Gui& gui) const {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  Pressed pressed = Pressed::none;
  if (Gui::begin_dialog("##ask-recover", is_open(),
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    if (is_open()) {
      const LeftWork& work = works_.front();
      const std::string title = work.session().title.empty() ? "Untitled" : work.session().title;
      ImGui::PushFont(gui.bold());
      ImGui::TextUnformatted("Work was left unsaved when Mesecina ended");
      ImGui::PopFont();
      ImGui::Dummy({1, 2 * unit});
      ImGui::TextUnformatted(fmt::format("{}, {} {} at {}", title, work.edits(),
                                         work.edits() == 1 ? "change," : "changes, the last", work.when())
                                 .c_str());
      if (works_.size() > 1) ImGui::TextDisabled("%zu more after this one", works_.size() - 1);
      ImGui::Dummy({1, 6 * unit});
      const ImVec2 size(120 * unit, 0);
      if (ImGui::Button("Recover", size)) pressed = Pressed::recover;
      ImGui::SameLine();
      if (ImGui::Button("Discard", size)) pressed = Pressed::discard;
      ImGui::SameLine();
      if (ImGui::Button("Not now", size)) pressed = Pressed::later;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return pressed;
}

}  // namespace mes

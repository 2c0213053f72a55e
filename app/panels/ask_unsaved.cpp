// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/ask_unsaved.h"

namespace mes {
namespace {
constexpr const char* kTitle = "##ask-unsaved";
}

void AskUnsaved::ask(std::string title, std::function<void()> then) {
  is_open_ = true;
  title_ = std::move(title);
  then_ = std::move(then);
}

void AskUnsaved::close() {
  is_open_ = false;
  then_ = {};
}

AskUnsaved::Answer AskUnsaved::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  Answer answer = Answer::none;
  if (Gui::begin_dialog(kTitle, is_open_, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::PushFont(gui.bold());
    ImGui::Text("%s has changes that are not saved", title_.c_str());
    ImGui::PopFont();
    ImGui::Dummy({1, 6 * unit});
    const ImVec2 size(120 * unit, 0);
    if (ImGui::Button("Save", size)) answer = Answer::save;
    ImGui::SameLine();
    if (ImGui::Button("Don't save", size)) answer = Answer::discard;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) answer = Answer::cancel;
    if (answer != Answer::none) is_open_ = false;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return answer;
}

}  // namespace mes

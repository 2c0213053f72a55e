// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/ask_unsaved.h"

#include <utility>

namespace mes {
namespace {
constexpr const char* kUnsavedTitle = "##ask-unsaved";
}

void AskUnsaved::ask(std::string title, Answers answers, std::string reason) {
  is_open_ = true;
  title_ = std::move(title);
  reason_ = std::move(reason);
  answers_ = std::move(answers);
}

void AskUnsaved::cancel() {
  is_open_ = false;
  answers_ = {};
}

void AskUnsaved::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  std::function<void()> answer;
  if (Gui::begin_dialog(kUnsavedTitle, is_open_, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    // File names may be long.
    ImGui::PushTextWrapPos(0.6F * screen.x);
    ImGui::PushFont(gui.bold());
    ImGui::Text("%s has changes that are not saved", title_.c_str());
    ImGui::PopFont();
    if (!reason_.empty()) ImGui::TextUnformatted(reason_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({1, 6 * unit});
    const ImVec2 size(120 * unit, 0);
    if (ImGui::Button("Save", size)) answer = answers_.save;
    ImGui::SameLine();
    if (ImGui::Button("Don't save", size)) answer = answers_.discard;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) cancel();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  if (!answer) return;
  cancel();
  answer();
}

}  // namespace mes

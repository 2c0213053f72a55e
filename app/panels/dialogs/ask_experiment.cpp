// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/ask_experiment.h"

#include <utility>

namespace mes {
namespace {
constexpr const char* kExperimentTitle = "##ask-experiment";
}

void AskExperiment::ask(std::filesystem::path file, std::function<void()> run) {
  is_open_ = true;
  file_ = std::move(file);
  run_ = std::move(run);
}

void AskExperiment::cancel() {
  is_open_ = false;
  run_ = {};
}

void AskExperiment::draw(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  std::function<void()> answer;
  if (Gui::begin_dialog(kExperimentTitle, is_open_,
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::PushTextWrapPos(0.6F * screen.x);
    ImGui::PushFont(gui.bold());
    ImGui::Text("%s is a program", file_.filename().c_str());
    ImGui::PopFont();
    ImGui::TextUnformatted(
        "An experiment is code that runs with your rights: it may read and change your files. Run it only if you "
        "know "
        "where it is from.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({1, 6 * unit});
    const ImVec2 size(120 * unit, 0);
    if (ImGui::Button("Run it", size)) answer = run_;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/ask_conflict.h"

#include <fmt/core.h>
#include <string>
#include <utility>

namespace mes {
namespace {

constexpr const char* kConflictTitle = "##ask-conflict";

void draw_number(const char* text, float right) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + right - ImGui::CalcTextSize(text).x);
  ImGui::TextUnformatted(text);
}

void draw_row(const Gui& gui, const char* what, const std::string& mine, const std::string& theirs) {
  const bool differs = mine != theirs;
  const float column = 120 * gui.unit();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what);
  if (differs) ImGui::PushFont(gui.bold());
  ImGui::TableNextColumn();
  draw_number(mine.c_str(), column);
  ImGui::TableNextColumn();
  draw_number(theirs.c_str(), column);
  if (differs) ImGui::PopFont();
}

void draw_heading(const Gui& gui) {
  const float column = 120 * gui.unit();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TableNextColumn();
  draw_number("in this window", column);
  ImGui::TableNextColumn();
  draw_number("in the file", column);
  ImGui::PopStyleColor();
}

void draw_counts(const Gui& gui, const Holdings& mine, const Holdings& theirs) {
  const float unit = gui.unit();
  if (!ImGui::BeginTable("counts", 3, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 80 * unit);
  ImGui::TableSetupColumn("mine", ImGuiTableColumnFlags_WidthFixed, 120 * unit);
  ImGui::TableSetupColumn("theirs", ImGuiTableColumnFlags_WidthFixed, 120 * unit);
  draw_heading(gui);
  draw_row(gui, "Samples", std::to_string(mine.samples), std::to_string(theirs.samples));
  draw_row(gui, "Balls", std::to_string(mine.balls), std::to_string(theirs.balls));
  const auto text = [](const std::optional<std::size_t>& count) {
    return count ? std::to_string(*count) : "none kept";
  };
  if (mine.edits || theirs.edits) draw_row(gui, "Edits", text(mine.edits), text(theirs.edits));
  ImGui::EndTable();
}

std::string shared_text(std::size_t shared) {
  if (shared == 0) return "No edit is the same in both.";
  return shared == 1 ? "The first edit is the same in both."
                     : fmt::format("The first {} edits are the same in both.", shared);
}

}  // namespace

void AskConflict::ask(FileConflict conflict, Answers answers) {
  conflict_ = std::move(conflict);
  answers_ = std::move(answers);
}

void AskConflict::cancel() {
  conflict_.reset();
  if (const Answers answers = std::exchange(answers_, {}); answers.cancel) answers.cancel();
}

void AskConflict::draw(const Gui& gui) {
  const Pressed pressed = draw_question(gui);
  if (pressed == Pressed::none) return;
  if (pressed == Pressed::cancel) {
    cancel();
    return;
  }
  const FileConflict conflict = *std::exchange(conflict_, std::nullopt);
  const Answers answers = std::exchange(answers_, {});
  if (pressed == Pressed::overwrite)
    answers.overwrite(conflict);
  else
    answers.save_as();
}

AskConflict::Pressed AskConflict::draw_question(const Gui& gui) const {
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * unit, 16 * unit});
  Pressed pressed = Pressed::none;
  if (Gui::begin_dialog(kConflictTitle, is_open(),
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize)) {
    if (is_open()) {
      ImGui::PushFont(gui.bold());
      ImGui::Text("%s has been changed by another program", conflict_->file.filename().c_str());
      ImGui::PopFont();
      ImGui::Dummy({1, 2 * unit});
      ImGui::TextUnformatted("Saving here would remove what was written to it since it was opened or last saved.");
      ImGui::Dummy({1, 4 * unit});
      if (conflict_->theirs)
        draw_counts(gui, conflict_->mine, *conflict_->theirs);
      else
        ImGui::Text("Its present contents cannot be shown: %s", conflict_->problem.c_str());
      if (conflict_->shared_edits) {
        ImGui::Dummy({1, 2 * unit});
        ImGui::TextDisabled("%s", shared_text(*conflict_->shared_edits).c_str());
      }
      ImGui::Dummy({1, 6 * unit});
      const ImVec2 size(120 * unit, 0);
      if (ImGui::Button("Save as...", size)) pressed = Pressed::save_as;
      ImGui::SameLine();
      if (ImGui::Button("Overwrite", size)) pressed = Pressed::overwrite;
      ImGui::SameLine();
      if (ImGui::Button("Cancel", size)) pressed = Pressed::cancel;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return pressed;
}

}  // namespace mes

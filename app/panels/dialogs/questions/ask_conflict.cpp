// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/questions/ask_conflict.h"

#include <fmt/core.h>
#include <array>
#include <string>
#include <utility>

#include "app/ui/widgets/paragraph.h"
#include "core/base/counted.h"

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
  draw_row(gui, "Samples", grouped(mine.samples), grouped(theirs.samples));
  draw_row(gui, "Balls", grouped(mine.balls), grouped(theirs.balls));
  const auto text = [](const std::optional<std::size_t>& count) { return count ? grouped(*count) : "none kept"; };
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

void AskConflict::draw_facts(const Gui& gui, float width) const {
  const float unit = gui.unit();
  ImGui::Dummy({1, 2 * unit});
  paragraph("Saving here would remove what was written to it since it was opened or last saved.", width);
  ImGui::Dummy({1, 4 * unit});
  if (conflict_->theirs)
    draw_counts(gui, conflict_->mine, *conflict_->theirs);
  else
    paragraph("Its present contents cannot be shown: " + conflict_->problem, width);
  if (!conflict_->shared_edits) return;
  ImGui::Dummy({1, 2 * unit});
  ImGui::TextDisabled("%s", shared_text(*conflict_->shared_edits).c_str());
}

void AskConflict::draw(const Gui& gui) {
  static constexpr std::array kAnswers{"Save as...", "Overwrite", "Cancel"};
  const std::string name = conflict_ ? conflict_->file.filename().string() : std::string();
  const auto answer = draw_question(gui, kConflictTitle, kAnswers, 0, name + " has been changed by another program",
                                    [this, &gui](float width) {
                                      if (conflict_) draw_facts(gui, width);
                                    });
  if (!answer || !conflict_) return;
  if (*answer == 2) return cancel();
  const FileConflict conflict = *std::exchange(conflict_, std::nullopt);
  const Answers answers = std::exchange(answers_, {});
  if (*answer == 1)
    answers.overwrite(conflict);
  else
    answers.save_as();
}

}  // namespace mes

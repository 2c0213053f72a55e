// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/work_in_progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "app/layers/words/verdict_word.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"

namespace mes {
namespace {

void progress_bar(const Gui& gui, const std::string& what, double fraction) {
  const float unit = gui.unit();
  ImGui::TextUnformatted(what.c_str());
  ImGui::SameLine();
  const float height = 6 * unit;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = 110 * unit;
  const float y = at.y + 0.5F * (ImGui::GetTextLineHeight() - height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, y}, {at.x + width, y + height}, gui.colors().border, 3 * unit);
  if (fraction > 0.0) {
    list.AddRectFilled({at.x, y}, {at.x + width * static_cast<float>(std::min(fraction, 1.0)), y + height},
                       gui.colors().accent, 3 * unit);
  } else {
    // Unknown progress: a moving piece.
    const float phase = static_cast<float>(0.5 - 0.5 * std::cos(3.0 * ImGui::GetTime()));
    list.AddRectFilled({at.x + 0.7F * width * phase, y}, {at.x + width * (0.7F * phase + 0.3F), y + height},
                       gui.colors().accent, 3 * unit);
  }
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
}

}  // namespace

void WorkInProgress::draw_recording() const {
  if (!record.is_recording()) return;
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 5 * unit, at.y + 0.5F * height}, 5 * unit,
                                              gui.colors().recording);
  ImGui::Dummy({14 * unit, height});
  ImGui::SameLine(0, 0);
  std::string text = counted(record.frames(), "frame");
  if (record.is_waiting_for_disk())
    text += ", waiting for the disk";
  else if (const std::size_t unwritten = record.unwritten(); unwritten > 1)
    text += ", " + grouped(unwritten) + " being written";
  ImGui::TextUnformatted(text.c_str());
  tooltip(gui, "Recording: a frame after each change");
  ImGui::SameLine(0, 16 * unit);
}

bool WorkInProgress::draw_compilation() const {
  const auto work = experiments.work();
  if (!work || std::chrono::duration<double, std::milli>(work->time).count() < kShownAfterMs) return false;
  progress_bar(gui, "Compiling " + work->file.filename().string(), 0.0);
  return true;
}

bool WorkInProgress::draw() const {
  if (files.is_saving()) {
    progress_bar(gui, "Saving " + files.saving_name(), 0.0);
  } else if (files.is_reading()) {
    progress_bar(gui, "Reading " + files.reading_name(), files.reading_progress());
    if (ImGui::SmallButton("Cancel")) files.cancel_reading();
    tooltip(gui, "Keep the present samples (Esc)");
    return true;
  }
  if (record.is_making_video()) {
    progress_bar(gui, "Making a video", 0.0);
    if (ImGui::SmallButton("Cancel")) record.cancel_video();
    tooltip(gui, "Make no video; the frames stay");
    return true;
  }
  if (lesson.is_under_way()) {
    progress_bar(gui, "Writing " + lesson.file().filename().string(), lesson.progress());
    if (ImGui::SmallButton("Cancel")) lesson.cancel();
    tooltip(gui, "Cancel the export of the lesson (Esc)");
    return true;
  }
  if (hold.is_held()) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    ImGui::TextUnformatted(hold.waiting().empty() ? "Update held" : "Update held; structures are behind");
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (actions.is_checked(ActionId::hold_update) && ImGui::SmallButton("Release"))
      actions.run(ActionId::hold_update);
    tooltip(gui, actions.tooltip_of(ActionId::hold_update));
    return true;
  }
  const EngineStatus status = engine.status();
  if (status.cancelled) {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    ImGui::TextUnformatted("Computation cancelled");
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (ImGui::SmallButton("Resume")) actions.run(ActionId::resume_computation);
    tooltip(gui, actions.tooltip_of(ActionId::resume_computation));
    return true;
  }
  if (!status.busy || status.busy_ms < kShownAfterMs) {
    // The dialog or panel that began it may lie behind others by now.
    if (!sweep.is_under_way()) return draw_compilation();
    progress_bar(gui, "Making a table", sweep.progress());
    if (ImGui::SmallButton("Cancel")) sweep.give_up();
    tooltip(gui, "Cancel the table of parameter values");
    return true;
  }
  progress_bar(gui, task_text(status.task), status.progress);
  if (ImGui::SmallButton("Cancel")) actions.run(ActionId::cancel_computation);
  tooltip(gui, actions.tooltip_of(ActionId::cancel_computation));
  return true;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/status_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/panels/changed_chips.h"
#include "app/panels/verdict.h"
#include "app/ui/icons.h"
#include "app/ui/theme.h"

namespace mes {
namespace {

// Shorter work would only flicker.
constexpr double kShownAfterMs = 100.0;
constexpr float kCoordinatesWidth = 190.0F;  // logical pixels
constexpr float kLeastRemark = 120.0F;

// As many digits as one pixel of the view can tell apart.
std::string coordinate(double value, double units_per_px) {
  std::array<char, 64> text{};
  const double magnitude = std::max(std::abs(value), units_per_px);
  const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(magnitude / units_per_px))) + 1, 3, 17);
  const bool plain = magnitude < 1e7 && units_per_px > 1e-7;
  if (plain) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(units_per_px))), 0, 12);
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  } else {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  }
  return text.data();
}

std::string grouped(std::size_t number) {
  std::string out = std::to_string(number);
  for (auto i = static_cast<std::ptrdiff_t>(out.size()) - 3; i > 0; i -= 3)
    out.insert(static_cast<std::size_t>(i), " ");
  return out;
}

std::string counts(const Editor& editor, double units_per_px) {
  const Document& document = editor.document();
  const auto some = [](std::size_t n, const char* noun) { return grouped(n) + ' ' + noun + (n == 1 ? "" : "s"); };
  std::string out = some(document.sample_count(), "sample");
  if (document.ball_count() != 0) {
    const std::string balls = some(document.ball_count(), "ball");
    out = document.sample_count() == 0 ? balls : out + ", " + balls;
  }
  const Selection& selection = editor.selection();
  if (!selection.is_empty()) out += ", " + grouped(selection.size()) + " selected";
  // Of one ball its radius is what one wants to know while it is being changed.
  Slot ball = kNoSlot;
  if (selection.size() == 1 && selection.ball_count() == 1) ball = selection.ball_slots().front();
  if (ball != kNoSlot) out += ", radius " + coordinate(document.disk(ball).radius, units_per_px);
  return out;
}

std::string coordinates(const Canvas& canvas) {
  if (!canvas.is_hovered()) return {};
  const double units = canvas.view().camera().units_per_pixel();
  const Vec2 p = canvas.pointer_world();
  return coordinate(p.x, units) + ", " + coordinate(p.y, units);
}

void progress(const PanelContext& context, const std::string& what, double fraction) {
  const float unit = context.gui.unit();
  ImGui::TextUnformatted(what.c_str());
  ImGui::SameLine();
  const float height = 6 * unit;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = 110 * unit;
  const float y = at.y + 0.5F * (ImGui::GetTextLineHeight() - height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, y}, {at.x + width, y + height}, context.gui.colors().border, 3 * unit);
  if (fraction > 0.0) {
    list.AddRectFilled({at.x, y}, {at.x + width * static_cast<float>(std::min(fraction, 1.0)), y + height},
                       context.gui.colors().accent, 3 * unit);
  } else {
    // Unknown: a piece that wanders.
    const float phase = static_cast<float>(0.5 - 0.5 * std::cos(3.0 * ImGui::GetTime()));
    list.AddRectFilled({at.x + 0.7F * width * phase, y}, {at.x + width * (0.7F * phase + 0.3F), y + height},
                       context.gui.colors().accent, 3 * unit);
  }
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
}

// A red dot and how many frames there are, while recording.
void draw_recording(const PanelContext& context) {
  const RecordDesk& record = context.record;
  if (!record.is_recording()) return;
  const float unit = context.gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 5 * unit, at.y + 0.5F * height}, 5 * unit,
                                              context.gui.colors().recording);
  ImGui::Dummy({14 * unit, height});
  ImGui::SameLine(0, 0);
  std::string text = grouped(record.frames()) + (record.frames() == 1 ? " frame" : " frames");
  if (record.is_waiting_for_disk())
    text += ", waiting for the disk";
  else if (const std::size_t unwritten = record.unwritten(); unwritten > 1)
    text += ", " + grouped(unwritten) + " being written";
  ImGui::TextUnformatted(text.c_str());
  tooltip(context.gui, "Recording: a frame after each change");
  ImGui::SameLine(0, 16 * unit);
}

// What is being done, with a way to stop it; false when nothing is.
bool draw_work(const PanelContext& context) {
  if (context.files.is_saving()) {
    progress(context, "Saving " + context.files.saving_name(), 0.0);
  } else if (context.files.is_reading()) {
    progress(context, "Reading " + context.files.reading_name(), 0.0);
    if (ImGui::SmallButton("Cancel")) context.files.cancel_reading();
    tooltip(context.gui, "Keep the present samples");
    return true;
  }
  if (context.record.is_making_video()) {
    progress(context, "Making a video", 0.0);
    if (ImGui::SmallButton("Cancel")) context.record.cancel_video();
    tooltip(context.gui, "Make no video; the frames stay");
    return true;
  }
  const EngineStatus status = context.engine.status();
  if (status.cancelled) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.gui.colors().warning);
    ImGui::TextUnformatted("Computation cancelled");
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (ImGui::SmallButton("Resume")) context.actions.run(ActionId::resume_computation);
    tooltip(context.gui, tooltip_of(ActionId::resume_computation));
    return true;
  }
  if (!status.busy || status.busy_ms < kShownAfterMs) return false;
  progress(context, "Computing " + status.task, status.progress);
  if (ImGui::SmallButton("Cancel")) context.actions.run(ActionId::cancel_computation);
  tooltip(context.gui, tooltip_of(ActionId::cancel_computation));
  return true;
}

}  // namespace

float status_bar_height(const Gui& gui) {
  return 28 * gui.unit();
}

void draw_status_bar(const PanelContext& context, const PanelArea& area) {
  const float unit = context.gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 5 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {7 * unit, 1 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (begin_panel("##status", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    const std::string right_text = coordinates(context.canvas);
    const std::string count_text = counts(context.editor, context.canvas.view().camera().units_per_pixel());
    const float count_width = ImGui::CalcTextSize(count_text.c_str()).x;
    const float end = ImGui::GetContentRegionMax().x;
    const float verdict_at = end - verdict_width(context);
    const float before_verdict = verdict_at - 14 * unit - count_width;
    const ChangedChips chips(context);
    // Where all has no room, what is being done or can be done says more than where the pointer is, and what changes
    // the picture unseen says more than either.
    const bool has_room = before_verdict > (kCoordinatesWidth + kLeastRemark) * unit + chips.full_width();
    const bool has_counts = before_verdict > chips.width_in(0.0F);
    const float counts_at = has_counts ? std::max(0.0F, before_verdict - (has_room ? kCoordinatesWidth * unit : 0.0F))
                                       : verdict_at - 14 * unit;
    const float chips_room = counts_at - kLeastRemark * unit;
    const float chips_at = std::max(0.0F, counts_at - chips.width_in(chips_room));
    const ImVec2 clip_from = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(clip_from, {clip_from.x + chips_at - 16 * unit, area.at.y + area.size.y}, true);
    draw_recording(context);
    if (!draw_work(context)) {
      const std::string& remark = context.messages.remark();
      if (!remark.empty()) {
        ImGui::TextUnformatted(remark.c_str());
        tooltip(context.gui, remark);
      } else {
        const std::string_view hint = context.canvas.tool().hint();
        ImGui::TextDisabled("%.*s", static_cast<int>(hint.size()), hint.data());
      }
    }
    if (const std::uint32_t every = context.picture.every(); every > 1) {
      ImGui::SameLine(0, 16 * unit);
      ImGui::PushStyleColor(ImGuiCol_Text, context.gui.colors().warning);
      ImGui::Text("1 of %u disks shown", every);
      ImGui::PopStyleColor();
      tooltip(context.gui,
              "There are so many large disks that painting them all would make the window slow. Pictures made by "
              "mesecina render have them all");
    }
    ImGui::PopClipRect();
    ImGui::SameLine(chips_at);
    chips.draw(chips_room);
    if (has_counts) {
      ImGui::SameLine(counts_at);
      ImGui::TextUnformatted(count_text.c_str());
    }
    if (has_room) {
      ImGui::SameLine(verdict_at - 14 * unit - ImGui::CalcTextSize(right_text.c_str()).x);
      ImGui::TextDisabled("%s", right_text.c_str());
    }
    ImGui::SameLine(verdict_at);
    draw_verdict(context);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void draw_problem(const PanelContext& context, ImVec2 at, float width) {
  const std::string problem = context.messages.problem();
  if (problem.empty()) return;
  const float unit = context.gui.unit();
  const float wanted = std::min(width, ImGui::CalcTextSize(problem.c_str()).x + 76 * unit);
  ImGui::SetNextWindowPos({at.x + 0.5F * (width - wanted), at.y});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.gui.colors().warning_soft);
  ImGui::PushStyleColor(ImGuiCol_Border, context.gui.colors().warning_border);
  ImGui::Begin("##problem", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  const float size = ImGui::GetTextLineHeight();
  const float start = ImGui::GetCursorPosY();
  ImGui::PushStyleColor(ImGuiCol_Text, context.gui.colors().warning);
  ImGui::PushTextWrapPos(wanted - 34 * unit);
  ImGui::TextUnformatted(problem.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::SameLine(wanted - 30 * unit);
  ImGui::SetCursorPosY(start);
  if (icon_button("close", Icon::close, 1.2F * size)) context.messages.clear_problem();
  tooltip(context.gui, "Close");
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace mes

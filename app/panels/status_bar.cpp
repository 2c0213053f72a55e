// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/status_bar.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "app/model/statistics_text.h"
#include "app/panels/changed_chips.h"
#include "app/ui/theme.h"

namespace mes {
namespace {

constexpr float kCoordinatesWidth = 190.0F;  // logical pixels
constexpr float kLeastRemark = 120.0F;

// As many digits as one pixel of the view can tell apart.
std::string coordinate(double value, double units_per_px) {
  const double magnitude = std::max(std::abs(value), units_per_px);
  const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(magnitude / units_per_px))) + 1, 3, 17);
  const bool plain = magnitude < 1e7 && units_per_px > 1e-7;
  if (plain) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(units_per_px))), 0, 12);
    return fmt::format("{:.{}f}", value, decimals);
  }
  return fmt::format("{:.{}g}", value, digits);
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
  BallSlot ball;
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

}  // namespace

float StatusBar::height() const {
  return 28 * gui.unit();
}

void StatusBar::draw(const PanelArea& area) const {
  const float unit = gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 5 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {7 * unit, 1 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (begin_panel("##status", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    const std::string right_text = coordinates(canvas);
    const std::string count_text = counts(editor, canvas.view().camera().units_per_pixel());
    const float count_width = ImGui::CalcTextSize(count_text.c_str()).x;
    const float end = ImGui::GetContentRegionMax().x;
    const float verdict_at = end - verdict.width();
    const float before_verdict = verdict_at - 14 * unit - count_width;
    const ChangedChips chips(gui, computation, messages);
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
    work.draw_recording();
    if (!work.draw()) {
      const std::string& remark = messages.remark();
      if (!remark.empty()) {
        ImGui::TextUnformatted(remark.c_str());
        tooltip(gui, remark);
      } else {
        const std::string_view hint = canvas.tool().hint();
        ImGui::TextDisabled("%.*s", static_cast<int>(hint.size()), hint.data());
      }
    }
    if (const std::uint32_t every = picture.every(); every > 1) {
      ImGui::SameLine(0, 16 * unit);
      ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
      ImGui::Text("1 of %u disks shown", every);
      ImGui::PopStyleColor();
      tooltip(gui,
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
    verdict.draw();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/status_bar.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "app/panels/bars/changed_chips.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/ui/screen/theme.h"
#include "core/base/counted.h"
#include "core/io/systems/map_conversion.h"

namespace mes {
namespace {

constexpr float kCoordinatesWidth = 190.0F;  // logical pixels
constexpr float kLeastRemark = 120.0F;

// Formats with as many digits as one pixel of the view can distinguish.
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

/// " m" if the document is a map in metres; empty without a map.
std::string unit_of(const Document& document) {
  const std::string unit = unit_of_lengths(document);
  return unit.empty() ? unit : " " + unit;
}

/// The plane of a map, for the tooltip of the coordinates.
std::string plane_in_words(const MapPlane& map) {
  if (!is_on_earth(map)) return fmt::format("Coordinates in {}, the unit of the drawing", map.plane_unit());
  const std::string system = map.system.empty() ? "WGS 84" : map.system.contains('[') ? "its own system" : map.system;
  if (map.projection == MapProjection::none) return fmt::format("Coordinates of {}, in {}", system, map.plane_unit());
  return fmt::format("Projected from {} to {}, {} about longitude {:.4f}, latitude {:.4f}", system, map.plane_unit(),
                     map.projection == MapProjection::azimuthal ? "azimuthal equidistant" : "equirectangular",
                     map.longitude, map.latitude);
}

std::string counts(const Editor& editor, double units_per_px) {
  const Document& document = editor.document();
  std::string out = counted(document.sample_count(), "sample");
  if (document.ball_count() != 0) {
    const std::string balls = counted(document.ball_count(), "ball");
    out = document.sample_count() == 0 ? balls : out + ", " + balls;
  }
  const Selection& selection = editor.selection();
  if (!selection.is_empty()) out += ", " + grouped(selection.size()) + " selected";
  // The radius of a single ball is what the user watches while changing it.
  BallSlot ball;
  if (selection.size() == 1 && selection.ball_count() == 1) ball = selection.ball_slots().front();
  if (ball != kNoSlot) out += ", radius " + coordinate(document.disk(ball).radius, units_per_px) + unit_of(document);
  return out;
}

// "Drawing every 2nd disk"; empty if all are drawn.
std::string share_text(std::uint32_t every) {
  if (every <= 1) return {};
  const bool is_teen = every % 100 >= 11 && every % 100 <= 13;
  const char* const ending = is_teen           ? "th"
                             : every % 10 == 1 ? "st"
                             : every % 10 == 2 ? "nd"
                             : every % 10 == 3 ? "rd"
                                               : "th";
  return "Drawing every " + std::to_string(every) + ending + " disk";
}

std::string coordinates(const Canvas& canvas, const Document& document) {
  // Without the pointer the unit stays, where its tooltip can be reached.
  const std::string unit = unit_of_lengths(document);
  if (!canvas.is_hovered()) return unit.empty() ? unit : "Lengths in " + unit;
  const double units = canvas.view_at_pointer().camera().units_per_pixel();
  const Vec2 p = canvas.pointer_world();
  return coordinate(p.x, units) + ", " + coordinate(p.y, units) + unit_of(document);
}

}  // namespace

// Only an item with a name makes the window wait for its tooltip.
void StatusBar::explain_text(const char* id, const std::string& explanation) const {
  const ImVec2 size = ImGui::GetItemRectSize();
  ImGui::SetCursorScreenPos(ImGui::GetItemRectMin());
  ImGui::InvisibleButton(id, {std::max(1.0F, size.x), std::max(1.0F, size.y)});
  tooltip(gui, explanation);
}

float StatusBar::height() const {
  return 28 * gui.unit();
}

void StatusBar::draw(const PanelArea& area) const {
  const float unit = gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 5 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {7 * unit, 1 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (begin_panel("##status", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    const std::string right_text = coordinates(canvas, editor.document());
    const std::string count_text = counts(editor, canvas.view_at_pointer().camera().units_per_pixel());
    const float count_width = ImGui::CalcTextSize(count_text.c_str()).x;
    const float end = ImGui::GetContentRegionMax().x;
    const float verdict_at = end - verdict.width(end);
    const float before_verdict = verdict_at - 14 * unit - count_width;
    // Wide enough for the digits of a deep zoom; otherwise constant, so that nothing moves with the pointer.
    const float coordinates_width =
        std::max(kCoordinatesWidth * unit, ImGui::CalcTextSize(right_text.c_str()).x + 24 * unit);
    const ChangedChips chips(gui, computation, messages);
    // If there is not enough room, the present task, message or hint is more important than the coordinates, and
    // invisible changes of the picture are more important than both. A hint may be cut, a message is shown whole.
    const std::string& remark = messages.remark();
    const float remark_width = remark.empty() ? 0.0F : ImGui::CalcTextSize(remark.c_str()).x + 24 * unit;
    const float left_width = std::max(kLeastRemark * unit, remark_width);
    const bool has_room = before_verdict > coordinates_width + left_width + chips.full_width();
    const bool has_counts = before_verdict > std::max(chips.width_in(0.0F), remark_width);
    const float counts_at =
        has_counts ? std::max(0.0F, before_verdict - (has_room ? coordinates_width : 0.0F)) : verdict_at - 14 * unit;
    const float chips_room = counts_at - kLeastRemark * unit;
    const float chips_at = std::max(0.0F, counts_at - chips.width_in(chips_room));
    const ImVec2 clip_from = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(clip_from, {clip_from.x + chips_at - 16 * unit, area.at.y + area.size.y}, true);
    work.draw_recording();
    const std::string share = share_text(picture.every());
    if (!work.draw()) {
      const std::string text = remark.empty() ? std::string(canvas.tool().hint()) : remark;
      const float share_width = share.empty() ? 0.0F : ImGui::CalcTextSize(share.c_str()).x + 16 * unit;
      const std::string shown = elided(text, chips_at - 16 * unit - ImGui::GetCursorPosX() - share_width);
      if (remark.empty())
        ImGui::TextDisabled("%s", shown.c_str());
      else
        ImGui::TextUnformatted(shown.c_str());
      if (!remark.empty() || shown != text) explain_text("##message", text);
    }
    if (!share.empty()) {
      ImGui::SameLine(0, 16 * unit);
      ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
      ImGui::TextUnformatted(share.c_str());
      ImGui::PopStyleColor();
      tooltip(gui,
              "Drawing all of these large disks would slow the window down. Snapshots and recordings show them all");
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
      if (const auto& map = editor.document().map()) {
        explain_text("##plane", plane_in_words(*map));
      }
    }
    ImGui::SameLine(verdict_at);
    verdict.draw(end);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace mes

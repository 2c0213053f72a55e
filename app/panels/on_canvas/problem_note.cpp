// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/problem_note.h"

#include <algorithm>

#include "app/ui/icons.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"

namespace mes {
namespace {

constexpr double kNoticeSeconds = 4.0;
constexpr double kSecondsPerLetter = 0.04;  // for the reader of a long notice
constexpr double kMostNoticeSeconds = 10.0;
constexpr double kFadeSeconds = 0.4;

struct NoteLook {
  const char* id;
  ImU32 ink;
  ImU32 ground;
  ImU32 border;
  float strength = 1.0F;
};

struct DrawnNote {
  float height = 0.0F;
  bool is_closed = false;
  bool is_hovered = false;
};

DrawnNote draw_note(const Gui& gui, const NoteLook& look, const std::string& text, ImVec2 at, float width) {
  DrawnNote out;
  const float unit = gui.unit();
  const float wanted = std::min(width, ImGui::CalcTextSize(text.c_str()).x + 76 * unit);
  ImGui::SetNextWindowPos({at.x + 0.5F * (width - wanted), at.y});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, look.strength);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.ground);
  ImGui::PushStyleColor(ImGuiCol_Border, look.border);
  ImGui::Begin(look.id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const float size = ImGui::GetTextLineHeight();
  const float start = ImGui::GetCursorPosY();
  ImGui::PushStyleColor(ImGuiCol_Text, look.ink);
  ImGui::PushTextWrapPos(wanted - 34 * unit);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::SameLine(wanted - 30 * unit);
  ImGui::SetCursorPosY(start);
  out.is_closed = icon_button("close", Icon::close, 1.2F * size);
  tooltip(gui, "Close (Esc)");
  out.height = ImGui::GetWindowHeight();
  out.is_hovered = ImGui::IsWindowHovered();
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  return out;
}

}  // namespace

float ProblemNote::draw(const Gui& gui, Messages& messages, ImVec2 at, float width, double now) {
  float height = 0.0F;
  const ThemeColors& colors = gui.colors();
  if (const std::string problem = messages.problem(); !problem.empty()) {
    const DrawnNote drawn =
        draw_note(gui, {"##problem", colors.warning, colors.warning_soft, colors.warning_border}, problem, at, width);
    if (drawn.is_closed) messages.clear_problem();
    height = drawn.height + 6 * gui.unit();
  }
  return height + draw_notice(gui, messages, {at.x, at.y + height}, width, now);
}

float ProblemNote::draw_notice(const Gui& gui, Messages& messages, ImVec2 at, float width, double now) {
  const std::string text = messages.notice();
  if (text.empty()) {
    notice_ends_.reset();
    return 0.0F;
  }
  if (!notice_ends_ || notice_number_ != messages.notice_number()) {
    notice_number_ = messages.notice_number();
    const double seconds = kNoticeSeconds + kSecondsPerLetter * static_cast<double>(text.size());
    notice_ends_ = now + std::min(seconds, kMostNoticeSeconds);
  }
  if (now >= *notice_ends_) {
    messages.clear_notice();
    notice_ends_.reset();
    return 0.0F;
  }
  const ThemeColors& colors = gui.colors();
  const double strength = std::clamp((*notice_ends_ - now) / kFadeSeconds, 0.0, 1.0);
  const DrawnNote drawn = draw_note(
      gui, {"##notice", colors.text, colors.raised, colors.border, static_cast<float>(strength)}, text, at, width);
  if (drawn.is_closed) messages.clear_notice();
  if (drawn.is_hovered) notice_ends_ = std::max(*notice_ends_, now + kNoticeSeconds);
  return drawn.height + 6 * gui.unit();
}

std::optional<double> ProblemNote::next_due(double now) const {
  if (!notice_ends_) return std::nullopt;
  return std::max(0.0, *notice_ends_ - kFadeSeconds - now);
}

}  // namespace mes

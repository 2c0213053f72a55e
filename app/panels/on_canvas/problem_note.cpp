// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/problem_note.h"

#include <algorithm>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

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

float width_of(const Gui& gui, const std::string& text, float room) {
  return std::min(room, ImGui::CalcTextSize(text.c_str()).x + 76 * gui.unit());
}

/// The height with the gap to the next message.
float height_of(const Gui& gui, const std::string& text, float room) {
  const float wrap = width_of(gui, text, room) - 34 * gui.unit() - ImGui::GetStyle().WindowPadding.x;
  return ImGui::CalcTextSize(broken_lines(text, wrap).c_str()).y + 2 * ImGui::GetStyle().WindowPadding.y +
         6 * gui.unit();
}

DrawnNote draw_note(const Gui& gui, const NoteLook& look, const std::string& text, ImVec2 at, ImVec2 pivot,
                    float room) {
  DrawnNote out;
  const float unit = gui.unit();
  const float wanted = width_of(gui, text, room);
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
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
  paragraph(text, wanted - 34 * unit - ImGui::GetCursorPosX());
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

void ProblemNote::choose_place(const Gui& gui, const std::string& text, const NoteRoom& room) {
  if (text == placed_text_) return;
  placed_text_ = text;
  const auto width = static_cast<float>(room.area.width());
  const Vec2 size{width_of(gui, text, width), height_of(gui, text, width)};
  place_ =
      least_hiding(room, size, {{0.5F, 0.0F}, {0.0F, 0.0F}, {1.0F, 0.0F}, {0.5F, 1.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}});
}

// Begins the time of a new notice.
bool ProblemNote::is_notice_over(const Messages& messages, double now) {
  if (!notice_ends_ || notice_number_ != messages.notice_number()) {
    notice_number_ = messages.notice_number();
    const double seconds = kNoticeSeconds + kSecondsPerLetter * static_cast<double>(messages.notice().size());
    notice_ends_ = now + std::min(seconds, kMostNoticeSeconds);
  }
  return now >= *notice_ends_;
}

float ProblemNote::draw(const Gui& gui, Messages& messages, const NoteRoom& room, double now) {
  if (messages.notice().empty()) {
    notice_ends_.reset();
  } else if (is_notice_over(messages, now)) {
    messages.clear_notice();
    notice_ends_.reset();
  }
  const std::string problem = messages.problem();
  const std::string notice = messages.notice();
  if (problem.empty() && notice.empty()) {
    placed_text_.clear();
    return 0.0F;
  }
  const char* const between = problem.empty() || notice.empty() ? "" : "\n\n";
  choose_place(gui, problem + between + notice, room);
  const auto width = static_cast<float>(room.area.width());
  const Vec2 side = room.area.high - room.area.low;
  const ImVec2 edge(static_cast<float>(room.area.low.x + place_.across * side.x),
                    static_cast<float>(room.area.low.y + place_.down * side.y));
  // From the lower edge the messages stack upwards.
  const float direction = place_.down > 0.0F ? -1.0F : 1.0F;
  const ImVec2 pivot(place_.across, place_.down);
  float taken = 0.0F;
  const ThemeColors& colors = gui.colors();
  const auto draw_problem = [&] {
    if (problem.empty()) return;
    const DrawnNote drawn = draw_note(gui, {"##problem", colors.warning, colors.warning_soft, colors.warning_border},
                                      problem, {edge.x, edge.y + direction * taken}, pivot, width);
    if (drawn.is_closed) messages.clear_problem();
    taken += drawn.height + 6 * gui.unit();
  };
  const auto draw_notice = [&] {
    if (notice.empty()) return;
    const double strength = std::clamp((*notice_ends_ - now) / kFadeSeconds, 0.0, 1.0);
    const DrawnNote drawn =
        draw_note(gui, {"##notice", colors.text, colors.raised, colors.border, static_cast<float>(strength)}, notice,
                  {edge.x, edge.y + direction * taken}, pivot, width);
    if (drawn.is_closed) messages.clear_notice();
    if (drawn.is_hovered) notice_ends_ = std::max(*notice_ends_, now + kNoticeSeconds);
    taken += drawn.height + 6 * gui.unit();
  };
  if (direction < 0.0F) draw_notice();
  draw_problem();
  if (direction > 0.0F) draw_notice();
  return place_.across == 0.5F && place_.down == 0.0F ? taken : 0.0F;
}

std::optional<double> ProblemNote::next_due(double now) const {
  if (!notice_ends_) return std::nullopt;
  return std::max(0.0, *notice_ends_ - kFadeSeconds - now);
}

}  // namespace mes

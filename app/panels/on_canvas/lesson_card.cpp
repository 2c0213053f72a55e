// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/lesson_card.h"

#include <fmt/core.h>
#include <algorithm>

#include "app/panels/on_canvas/paper_on_canvas.h"
#include "app/picture/caption_text.h"
#include "app/ui/icons.h"
#include "app/ui/theme.h"

namespace mes {
namespace {

constexpr float kShare = 0.3F;    // share of the available width
constexpr float kLeast = 220.0F;  // logical pixels
constexpr float kMost = 520.0F;
constexpr float kLessonMargin = 22.0F;

}  // namespace

float LessonCard::width(float room) const {
  const float unit = gui.unit();
  return std::min(std::clamp(kShare * room, kLeast * unit, kMost * unit), 0.5F * room);
}

// Draws on the background of the canvas, so that the text is readable if the drawing extends below it.
void LessonCard::draw_caption(const PanelArea& area) const {
  constexpr double kLettersInAColumn = 17.0;
  constexpr double kLargest = 26.0;
  constexpr double kFoot = 90.0;  // height of the buttons
  const float unit = gui.unit();
  const double column = static_cast<double>(area.size.x / unit) - 2.0 * static_cast<double>(kLessonMargin);
  const double height = static_cast<double>(area.size.y / unit) - 2.0 * static_cast<double>(kLessonMargin) - kFoot;
  if (!(column > 0.0) || !(height > 0.0)) return;
  ImGui::GetBackgroundDrawList()->AddRectFilled(area.at, {area.at.x + area.size.x, area.at.y + area.size.y},
                                                to_imgui(canvas));
  const CaptionLook look{
      .width = column, .letters = std::min(column / kLettersInAColumn, kLargest), .ink = paper_colors(canvas).ink};
  const FittedCaption fitted = fit_caption(caption_text(presenter.caption()), look, height, measure_on_canvas(gui));
  paint_on_canvas(gui, fitted.drawing, {area.at.x + kLessonMargin * unit, area.at.y + kLessonMargin * unit});
}

LessonCard::Wish LessonCard::draw_buttons(const PanelArea& area) const {
  Wish out = Wish::none;
  const float unit = gui.unit();
  const float button = 1.5F * ImGui::GetTextLineHeight();
  const bool is_edited = !presenter.is_playing() && presenter.is_edited();
  ImGui::SetNextWindowPos({area.at.x, area.at.y + area.size.y}, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowSize({area.size.x, 0});
  ImGui::Begin("##lesson", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBackground);
  if (is_edited) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("You have edited the drawing");
    ImGui::SameLine(0, 8 * unit);
    if (ImGui::Button("Take back")) out = Wish::restore;
    tooltip(gui, "Show the drawing of this step again");
    bool keeps = presenter.keeps_edits();
    if (ImGui::Checkbox("Keep it in the next steps", &keeps)) presenter.set_keeps_edits(keeps);
    tooltip(gui, "On: the next steps apply to your drawing; off: they show the drawing of the lesson again");
  }
  const auto step_button = [&](const char* id, Icon icon, ActionId action, bool enabled, Wish wish) {
    if (icon_button(id, icon, button, ButtonLook::plain, enabled)) out = wish;
    tooltip(gui, actions.tooltip_of(action));
    ImGui::SameLine(0, 4 * unit);
  };
  const std::size_t last = presenter.step_count() - 1;
  step_button("back", Icon::step_back, ActionId::previous_bundle, presenter.step() > 0, Wish::back);
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%s", fmt::format("{} / {}", presenter.step() + 1, last + 1).c_str());
  ImGui::SameLine(0, 4 * unit);
  step_button("on", Icon::step_forward, ActionId::next_bundle, presenter.step() < last || presenter.is_playing(),
              Wish::on);
  ImGui::SameLine(0, 12 * unit);
  bool plays = presenter.plays_edits();
  const ButtonLook look = plays ? ButtonLook::on : ButtonLook::plain;
  if (icon_button("plays", Icon::play, button, look)) presenter.set_plays_edits(!plays);
  tooltip(gui, "Show the edits between two steps one after the other; off: all at once");
  ImGui::SameLine(0, 4 * unit);
  if (icon_button("end", Icon::close, button)) out = Wish::end;
  tooltip(gui, "End the lesson (Esc) and restore the document");
  ImGui::End();
  return out;
}

LessonCard::Wish LessonCard::draw(const PanelArea& area) const {
  draw_caption(area);
  return draw_buttons(area);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/cards/lesson_card.h"

#include <fmt/core.h>
#include <algorithm>
#include <vector>

#include "app/panels/on_canvas/marks/paper_on_canvas.h"
#include "app/picture/paper/caption_text.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"

namespace mes {
namespace {

constexpr double kLessonMargin = 18.0;  // logical pixels
constexpr double kButtonsWidth = 210.0;
constexpr double kLeastHeight = 64.0;   // of the buttons
constexpr double kMostOfHeight = 0.36;  // share of the height that a long caption may take
// Letters of a thirtieth of the height of the picture can be read from the last row.
constexpr double kLettersOfHeight = 1.0 / 30.0;
constexpr double kLeastCaptionLetters = 17.0;
constexpr double kMostCaptionLetters = 48.0;

}  // namespace

// Draws on the background of the canvas, so that the text is readable if the drawing extends below it.
float LessonCard::draw_caption(const PanelArea& area) const {
  const auto unit = static_cast<double>(gui.unit());
  const double width = static_cast<double>(area.size.x) / unit;
  const double height = static_cast<double>(area.size.y) / unit;
  const double column = width - 2.0 * kLessonMargin - std::min(kButtonsWidth, 0.4 * width);
  const double most = kMostOfHeight * height - 2.0 * kLessonMargin;
  double taken = std::min(kLeastHeight, height);
  FittedCaption fitted;
  if (column > 0.0 && most > 0.0) {
    const CaptionLook look{
        .width = column,
        .letters = std::clamp(kLettersOfHeight * height, kLeastCaptionLetters, kMostCaptionLetters),
        .ink = paper_colors(canvas).ink};
    std::vector<CaptionText> captions;
    for (const LessonStep& step : presenter.lesson().steps) captions.push_back(caption_text(step.caption));
    fitted = fit_caption(caption_text(presenter.caption()), look, most, measure_on_canvas(gui), captions);
    taken = std::max(taken, fitted.drawing.height + 2.0 * kLessonMargin);
  }
  const float top = area.at.y + area.size.y - static_cast<float>(taken * unit);
  ImGui::GetBackgroundDrawList()->AddRectFilled({area.at.x, top}, {area.at.x + area.size.x, area.at.y + area.size.y},
                                                to_imgui(canvas));
  const auto margin = static_cast<float>(kLessonMargin * unit);
  const double free = taken - fitted.drawing.height - 2.0 * kLessonMargin;
  paint_on_canvas(gui, fitted.drawing, {area.at.x + margin, top + margin + static_cast<float>(0.5 * free * unit)});
  return static_cast<float>(taken * unit);
}

LessonCard::Wish LessonCard::draw_title(const PanelArea& area) const {
  ImGui::SetNextWindowPos(area.at);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_imgui(canvas));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::Begin("##lesson-title", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  const bool is_clicked = hit_area("title", area.size);
  const auto unit = static_cast<double>(gui.unit());
  const double width = static_cast<double>(area.size.x) / unit;
  const double height = static_cast<double>(area.size.y) / unit;
  const PaperColors colors = paper_colors(canvas);
  const auto centered = [&](const std::string& text, double letters, double most, Rgb ink, double middle) {
    const CaptionLook look{.width = 0.8 * width, .letters = letters, .ink = ink};
    const PaperDrawing drawing = fit_caption(caption_text(text), look, most, measure_on_canvas(gui)).drawing;
    const double left = 0.5 * (width - drawing.width);
    const double top = middle - 0.5 * drawing.height;
    paint(*ImGui::GetWindowDrawList(), gui, drawing,
          {area.at.x + static_cast<float>(left * unit), area.at.y + static_cast<float>(top * unit)});
  };
  centered(presenter.lesson().title, std::clamp(height / 11.0, 28.0, 120.0), 0.5 * height, colors.ink, 0.43 * height);
  const std::size_t steps = presenter.step_count();
  const std::string key = actions.keymap().key_of(ActionId::next_bundle);
  centered(fmt::format("{}{}", counted(steps, "step"),
                       key.empty() ? std::string() : fmt::format("; {} or a click begins", key)),
           std::clamp(height / 36.0, 14.0, 40.0), 0.2 * height, colors.quiet, 0.66 * height);
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  return is_clicked ? Wish::on : Wish::none;
}

LessonCard::Wish LessonCard::draw_buttons(const PanelArea& area) const {
  Wish out = Wish::none;
  const float unit = gui.unit();
  const float button = 1.5F * ImGui::GetTextLineHeight();
  const bool is_edited = !presenter.is_playing() && presenter.is_edited();
  ImGui::SetNextWindowPos({area.at.x + area.size.x, area.at.y + area.size.y}, ImGuiCond_Always, {1.0F, 1.0F});
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
    if (checkbox("Keep it in the next steps", &keeps)) presenter.set_keeps_edits(keeps);
    tooltip(gui, "On: the next steps apply to your drawing; off: they show the drawing of the lesson again");
  }
  const auto step_button = [&](const char* id, Icon icon, ActionId action, bool enabled, Wish wish) {
    if (icon_button(id, icon, button, ButtonLook::plain, enabled)) out = wish;
    tooltip(gui, actions.tooltip_of(action));
    ImGui::SameLine(0, 4 * unit);
  };
  const std::size_t last = presenter.step_count() - 1;
  step_button("back", Icon::step_back, ActionId::previous_bundle,
              presenter.step() > 0 || !presenter.lesson().title.empty(), Wish::back);
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

std::pair<LessonCard::Wish, float> LessonCard::draw(const PanelArea& area) const {
  const float height = draw_caption(area);
  return {draw_buttons(area), height};
}

}  // namespace mes

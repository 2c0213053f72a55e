// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/lesson_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/picture/paper/caption_text.h"
#include "app/playing/lesson_walk.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kLeastOfSteps = 44.0F;  // logical pixels
constexpr float kLeastOfCaption = 48.0F;
constexpr float kCaptionShare = 0.45F;

std::string name_of_step(const LessonStep& step) {
  const std::string name = name_of(caption_text(step.caption));
  return name.empty() ? "(no caption)" : name;
}

}  // namespace

void LessonPanel::draw() {
  if (presenter_.is_running()) {
    ImGui::TextDisabled("The lesson is being presented");
    if (const auto clicked = draw_steps(presenter_.lesson(), presenter_.step(), 0.0F)) go_to_(*clicked);
    return;
  }
  const std::optional<std::size_t> chosen = lesson_editor_.chosen();
  if (shown_ != lesson_editor_.lesson() || caption_of_ != chosen) {
    shown_ = lesson_editor_.lesson();
    caption_of_ = chosen;
    title_ = shown_.title;
    caption_ = chosen ? shown_.steps[*chosen].caption : std::string();
  }
  draw_head();
  if (presenter_.is_running()) return;
  if (shown_.steps.empty()) {
    quiet_paragraph(
        "A step records the samples, the layers, the number type and the view as they are now. Set up what it should "
        "show, then mark it.");
    return;
  }
  const float unit = gui_.unit();
  const float room = ImGui::GetContentRegionAvail().y;
  const float between = ImGui::GetStyle().ItemSpacing.y;
  const float buttons = ImGui::GetFrameHeightWithSpacing() + 3 * between;
  const float caption = std::max(kLeastOfCaption * unit, kCaptionShare * room);
  const float steps = std::max(kLeastOfSteps * unit, chosen ? room - buttons - caption - between : room);
  if (const auto clicked = draw_steps(shown_, chosen, steps)) {
    lesson_editor_.choose(*clicked);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return go_to_(*clicked);
  }
  if (chosen) draw_chosen(caption);
}

void LessonPanel::step(std::ptrdiff_t rows) {
  const std::size_t count =
      presenter_.is_running() ? presenter_.lesson().steps.size() : lesson_editor_.lesson().steps.size();
  if (count == 0) return;
  const auto chosen = presenter_.is_running() ? std::optional(presenter_.step()) : lesson_editor_.chosen();
  const std::size_t next = chosen ? row_beside(static_cast<std::ptrdiff_t>(*chosen), rows, count) : 0;
  if (presenter_.is_running())
    go_to_(next);
  else
    lesson_editor_.choose(next);
}

void LessonPanel::draw_head() {
  const float unit = gui_.unit();
  const auto button = [this](const char* label, ActionId id) {
    ImGui::BeginDisabled(!actions_.is_enabled(id));
    if (ImGui::Button(label)) actions_.run(id);
    ImGui::EndDisabled();
    tooltip(gui_, actions_.tooltip_of(id));
  };
  button("Mark a step", ActionId::mark_step);
  ImGui::SameLine(0, 4 * unit);
  button("Present", ActionId::present_lesson);
  ImGui::SameLine(0, 4 * unit);
  button("Export...", ActionId::export_lesson);
  const float size = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - size);
  if (icon_button("take-back", Icon::undo, size, ButtonLook::plain, lesson_editor_.can_take_back()))
    lesson_editor_.take_back();
  tooltip(gui_, "Undo the last change of the lesson");
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::InputTextWithHint("##title", "Title of the lesson", &title_)) lesson_editor_.type_title(title_);
  if (ImGui::IsItemDeactivated()) lesson_editor_.end_typing();
}

std::optional<std::size_t> LessonPanel::draw_steps(const Lesson& lesson, std::optional<std::size_t> current,
                                                   float height) {
  std::optional<std::size_t> clicked;
  if (ImGui::BeginChild("##steps", {0, height})) {
    const Listed now{current, lesson.steps.size(), ImGui::GetWindowHeight()};
    const bool has_changed = std::exchange(listed_, now) != now;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      const std::string name = fmt::format("{}. {}", i + 1, name_of_step(lesson.steps[i]));
      const std::string seconds = fmt::format("{:.3g} s", seconds_of(lesson.steps[i]));
      const float width = ImGui::GetContentRegionAvail().x;
      const float right = ImGui::CalcTextSize(seconds.c_str()).x;
      const float left = ImGui::GetCursorPosX();
      if (ImGui::Selectable("##step", current == i, ImGuiSelectableFlags_AllowDoubleClick)) clicked = i;
      if (!presenter_.is_running())
        tooltip(gui_, "Double click: present the lesson from this step on; Esc comes back");
      if (has_changed && current == i) ImGui::SetScrollHereY();
      ImGui::SameLine(left);
      ImGui::TextUnformatted(elided(name, width - right - 18 * gui_.unit()).c_str());
      ImGui::SameLine(left + width - right - 6 * gui_.unit());
      ImGui::TextDisabled("%s", seconds.c_str());
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  return clicked;
}

void LessonPanel::draw_chosen(float height) {
  ImGui::Separator();
  draw_buttons();
  const std::string typed = caption_;
  const bool has_changed = caption_field_.draw("##caption", caption_, {-1.0F, height});
  if (is_left_by_escape()) {
    caption_ = typed;
  } else if (has_changed) {
    lesson_editor_.type_caption(caption_);
  }
  if (ImGui::IsItemDeactivated()) lesson_editor_.end_typing();
  if (caption_.empty() && !ImGui::IsItemActive()) {
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::GetWindowDrawList()->AddText({corner.x + padding.x, corner.y + padding.y},
                                        ImGui::GetColorU32(ImGuiCol_TextDisabled), "Caption of this step");
  }
  tooltip(gui_, "# Heading, - item, **bold**, *italics*, $\\alpha^2$; an empty line begins a paragraph");
}

void LessonPanel::draw_buttons() {
  const float unit = gui_.unit();
  if (ImGui::Button("Mark again")) lesson_editor_.mark_again();
  tooltip(gui_, "Replace this step by the present state; its caption stays");
  const auto move_button = [&](const char* id, ImGuiDir direction, int places, const char* explanation) {
    ImGui::SameLine(0, 4 * unit);
    ImGui::BeginDisabled(!lesson_editor_.can_move(places));
    if (ImGui::ArrowButton(id, direction)) lesson_editor_.move(places);
    ImGui::EndDisabled();
    tooltip(gui_, explanation);
  };
  move_button("##up", ImGuiDir_Up, -1, "Show this step before the one above");
  move_button("##down", ImGuiDir_Down, 1, "Show this step after the one below");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("Remove")) {
    lesson_editor_.remove();
    return;
  }
  const std::optional<std::size_t> chosen = lesson_editor_.chosen();
  if (!chosen) return;
  ImGui::SameLine(0, 8 * unit);
  ImGui::SetNextItemWidth(std::max(48 * unit, ImGui::GetContentRegionAvail().x));
  double seconds = seconds_of(lesson_editor_.lesson().steps[*chosen]);
  if (number_field("##seconds", seconds, "%.3g s", NumberRange{0.0, kLongestLessonStep}))
    lesson_editor_.set_seconds(seconds);
  tooltip(gui_, "Duration in a video; type 0 for the time that its caption takes to read");
}

}  // namespace mes

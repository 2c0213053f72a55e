// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/cards/annotation_card.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "app/picture/paper/rich_text.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "render/device/convert.h"

namespace mes {
namespace {

constexpr float kAnnotationWidth = 330.0F;

const char* kind_name(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::text: return "Text";
    case AnnotationKind::leader: return "Leader";
    case AnnotationKind::arrow: return "Arrow";
    case AnnotationKind::distance: return "Distance";
    case AnnotationKind::angle: return "Angle";
    case AnnotationKind::radius: return "Radius";
    case AnnotationKind::highlight: return "Highlight";
    case AnnotationKind::center_line: return "Centre line";
  }
  return "";
}

const char* explanation_of(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::text: return "Text at a point";
    case AnnotationKind::leader: return "Text with a line to an element";
    case AnnotationKind::arrow: return "An arrow from the first point to the second one";
    case AnnotationKind::distance: return "A dimension line between the two points";
    case AnnotationKind::angle: return "The angle at the second point";
    case AnnotationKind::radius: return "The circle through the three points, and its radius";
    case AnnotationKind::highlight: return "Elements that stay highlighted, with optional text";
    case AnnotationKind::center_line:
      return "The two points are the ends of the line that the layers of centre lines show";
  }
  return "";
}

/// Draws the kinds with the same number of anchors, which can replace each other.
void draw_kinds(const Gui& gui, Annotation& annotation) {
  bool is_first = true;
  for (std::size_t i = 0; i < kAnnotationKinds; ++i) {
    const auto kind = static_cast<AnnotationKind>(i);
    const bool is_highlight = annotation.kind == AnnotationKind::highlight;
    const bool can_be = is_highlight
                            ? kind == annotation.kind
                            : kind != AnnotationKind::highlight && anchor_count(kind) == annotation.anchors.size();
    if (!can_be) continue;
    if (!std::exchange(is_first, false)) ImGui::SameLine();
    if (choice_button(kind_name(kind), annotation.kind == kind)) annotation.kind = kind;
    tooltip(gui, explanation_of(kind));
  }
}

}  // namespace

bool AnnotationCard::draw_words(const Gui& gui, Annotation& annotation, bool is_new) {
  const float unit = gui.unit();
  // A shape may need no text, and the next key may be meant for a tool.
  if (is_new && !shows_without_words(annotation.kind)) ImGui::SetKeyboardFocusHere();
  const std::string before = annotation.text;
  const bool is_entered =
      words_.draw("##words", annotation.text, {kAnnotationWidth * unit, 2.6F * ImGui::GetTextLineHeight()},
                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CtrlEnterForNewLine);
  const bool is_left = is_left_by_escape();
  if (is_left) annotation.text = before;
  if (annotation.text.size() > kMostAnnotationBytes) annotation.text.resize(kMostAnnotationBytes);
  const RichText words =
      rich_text(annotation.text, "", annotation.letters, [](const std::string&, double, Face) { return 0.0; });
  ImGui::PushFont(gui.small());
  const bool is_dimension = annotation.kind != AnnotationKind::highlight && anchor_count(annotation.kind) > 1 &&
                            annotation.kind != AnnotationKind::arrow &&
                            annotation.kind != AnnotationKind::center_line;
  const std::string hint = is_dimension ? "Empty for the number alone; \\value is the number, as in $d = \\value$"
                                        : "$r_i^2$, \\alpha, \\textbf{bold}; Ctrl+Enter: another line";
  quiet_paragraph(words.complaint.empty() ? hint : words.complaint + "; it is shown as typed",
                  kAnnotationWidth * unit);
  ImGui::PopFont();
  return is_entered || is_left;
}

void AnnotationCard::draw_look(const Gui& gui, Annotation& annotation) {
  const float unit = gui.unit();
  slider(gui, "##letters", annotation.letters, kLeastLetters, kMostLetters,
         {.format = "%.0f px", .is_logarithmic = true, .width = 130 * unit});
  tooltip(gui, "Size of the text");
  ImGui::SameLine();
  bool has_color = annotation.color.has_value();
  if (checkbox("Colour", &has_color)) {
    if (has_color)
      annotation.color = palette::vermilion;
    else
      annotation.color.reset();
  }
  tooltip(gui, "Without one, it is dark on a light canvas and light on a dark one");
  if (!annotation.color) return;
  ImGui::SameLine();
  glm::vec3 color = render::to_vec3(*annotation.color);
  if (ImGui::ColorEdit3("##color", glm::value_ptr(color), ImGuiColorEditFlags_NoInputs))
    annotation.color = render::to_rgb(color);
  tooltip(gui, "Colour of text and lines");
}

void AnnotationCard::draw(const Gui& gui, AnnotationEditor& annotations, ImVec2 beside, const ImVec2 (&room)[2],
                          const std::function<void(const Error&)>& report) {
  annotations.follow();
  const Annotation* const current = annotations.current();
  if (current == nullptr) return;
  const float unit = gui.unit();
  const bool is_new = annotations.choice_number() != choice_number_;
  choice_number_ = annotations.choice_number();
  const ImVec2 size{(kAnnotationWidth + 24) * unit, 150 * unit};
  if (is_new) {
    // The card goes below the text, or above it if there is no room below.
    const float below = beside.y + 30 * unit;
    at_ = {beside.x, below + size.y <= room[1].y ? below : beside.y - size.y - 40 * unit};
  }
  at_.x = std::max(room[0].x, std::min(at_.x, room[1].x - size.x));
  at_.y = std::max(room[0].y, std::min(at_.y, room[1].y - size.y));
  ImGui::SetNextWindowPos(at_, ImGuiCond_Always);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  ImGui::Begin("##annotation", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  Annotation changed = *current;
  draw_kinds(gui, changed);
  ImGui::SameLine((kAnnotationWidth - 8) * unit);
  bool is_closed = icon_button("close", Icon::close, ImGui::GetTextLineHeight());
  tooltip(gui, "Close (Enter or Esc)");
  is_closed = draw_words(gui, changed, is_new) || is_closed;
  draw_look(gui, changed);
  ImGui::SameLine();
  const bool is_erased = ImGui::Button("Delete");
  tooltip(gui, "Delete the annotation");
  ImGui::End();
  ImGui::PopStyleVar();
  const auto check = [&](const Expected<void>& done) {
    if (!done) report(done.error());
  };
  if (changed != *current) check(annotations.change(std::move(changed)));
  if (is_erased) check(annotations.erase());
  if (is_closed) annotations.close();
}

}  // namespace mes

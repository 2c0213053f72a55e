// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/selection_panel.h"

#include <array>

#include "app/ui/number_field.h"
#include "app/ui/widgets.h"
#include "core/formula/formula.h"
#include "core/io/text_numbers.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kGap = 4.0F;  // logical pixels
constexpr float kLabelWidth = 72.0F;

void label(const Gui& gui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kLabelWidth * gui.unit());
}

}  // namespace

void SelectionPanel::report(const Expected<void>& done) {
  if (!done) return refusal_.say(done.error());
  refusal_.forget();
  if (desk_.numbers().is_in(canvas_.view().free_box())) return;
  const std::string key = actions_.keymap().key_of(ActionId::fit_selection);
  messages_.remark("What is selected lies outside the view: " + descriptor_of(ActionId::fit_selection).name +
                   (key.empty() ? "" : " (" + key + ")") + " shows it");
}

void SelectionPanel::number(const char* label, double value, float width, const char* explanation,
                            const std::function<Expected<void>(double)>& use) {
  std::string text;
  append_number(text, value);
  ImGui::SetNextItemWidth(width);
  const bool is_left = formula_field(label, "", text);
  tooltip(gui_, explanation);
  if (!is_left) return;
  const auto number = number_of(text);
  report(number ? use(*number) : std::unexpected(number.error()));
}

void SelectionPanel::wish(const char* label, const char* hint, std::string& text, const char* button,
                          const char* explanation, const std::function<Expected<void>(double)>& use) {
  const float unit = gui_.unit();
  const float width = ImGui::CalcTextSize(button).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(std::max(40 * unit, ImGui::GetContentRegionAvail().x - width - kGap * unit));
  const bool is_entered = ImGui::InputTextWithHint(label, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
  tooltip(gui_, explanation);
  ImGui::SameLine(0, kGap * unit);
  const bool is_pressed = ImGui::Button(button);
  tooltip(gui_, explanation);
  if (!is_entered && !is_pressed) return;
  const auto number = number_of(text);
  report(number ? use(*number) : std::unexpected(number.error()));
}

void SelectionPanel::action_button(ActionId id, const char* label) {
  ImGui::BeginDisabled(!actions_.is_enabled(id));
  if (ImGui::Button(label)) actions_.run(id);
  ImGui::EndDisabled();
  tooltip(gui_, actions_.tooltip_of(id));
}

void SelectionPanel::draw() {
  const SelectionDesk::Numbers numbers = desk_.numbers();
  if (numbers.samples + numbers.balls == 0) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled(
        "Nothing is selected. Click a sample or a ball, or drag a box around some, to set them by number.");
    ImGui::PopTextWrapPos();
    return;
  }
  // Shorter than the panel at a large scale, it scrolls below its head.
  if (ImGui::BeginChild("##selection")) {
    ImGui::TextUnformatted(counted(numbers.samples, numbers.balls).c_str());
    draw_place();
    draw_motion();
    if (numbers.samples + numbers.balls > 1) draw_arrangement();
    draw_formulas();
  }
  ImGui::EndChild();
}

void SelectionPanel::draw_place() {
  const SelectionDesk::Numbers numbers = desk_.numbers();
  const float unit = gui_.unit();
  const bool is_one = numbers.samples + numbers.balls == 1;
  label(gui_, is_one ? "Place" : "Middle");
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - kGap * unit);
  number("##x", numbers.middle.x, half, "x; an expression such as 2/3 or sqrt(2) is computed when the field is left",
         [&](double x) {
           return desk_.move_middle_to({x, numbers.middle.y});
         });
  ImGui::SameLine(0, kGap * unit);
  number("##y", numbers.middle.y, half, "y; an expression such as 2/3 or sqrt(2) is computed when the field is left",
         [&](double y) {
           return desk_.move_middle_to({numbers.middle.x, y});
         });
  if (numbers.balls == 0) return;
  label(gui_, "Radius");
  number("##r", numbers.radius, half,
         numbers.balls == 1 ? "Radius of the ball" : "Radius of all balls; that of the largest is shown",
         [&](double r) { return desk_.set_radius(r); });
}

void SelectionPanel::draw_motion() {
  const SelectionDesk::Numbers numbers = desk_.numbers();
  const float unit = gui_.unit();
  label(gui_, "Move by");
  const float button = ImGui::CalcTextSize("Move").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float half = std::max(30 * unit, 0.5F * (ImGui::GetContentRegionAvail().x - button - 2 * kGap * unit));
  ImGui::SetNextItemWidth(half);
  bool is_entered = ImGui::InputTextWithHint("##dx", "dx", &step_x_, ImGuiInputTextFlags_EnterReturnsTrue);
  tooltip(gui_, "Step along x");
  ImGui::SameLine(0, kGap * unit);
  ImGui::SetNextItemWidth(half);
  is_entered = ImGui::InputTextWithHint("##dy", "dy", &step_y_, ImGuiInputTextFlags_EnterReturnsTrue) || is_entered;
  tooltip(gui_, "Step along y");
  ImGui::SameLine(0, kGap * unit);
  if (ImGui::Button("Move") || is_entered) {
    const auto dx = step_x_.empty() ? Expected<double>(0.0) : number_of(step_x_);
    const auto dy = step_y_.empty() ? Expected<double>(0.0) : number_of(step_y_);
    report(!dx ? std::unexpected(dx.error()) : !dy ? std::unexpected(dy.error()) : desk_.move_by({*dx, *dy}));
  }
  if (numbers.samples + numbers.balls < 2) return;
  label(gui_, "Turn by");
  wish("##degrees", "degrees", degrees_, "Turn", "About the middle, counter-clockwise, in degrees",
       [&](double degrees) { return desk_.turn(degrees); });
  label(gui_, "Scale by");
  wish("##factor", "factor", factor_, "Scale", "About the middle; radii are multiplied, too",
       [&](double factor) { return desk_.scale(factor); });
}

void SelectionPanel::draw_arrangement() {
  const float unit = gui_.unit();
  const auto row = [&](const char* name, std::span<const std::pair<ActionId, const char*>> buttons) {
    label(gui_, name);
    bool is_first = true;
    for (const auto& [id, text] : buttons) {
      if (!is_first) {
        ImGui::SameLine(0, kGap * unit);
        const float width = ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (ImGui::GetCursorPosX() + width > ImGui::GetContentRegionMax().x) {
          ImGui::NewLine();
          ImGui::SetCursorPosX(kLabelWidth * unit);
        }
      }
      is_first = false;
      action_button(id, text);
    }
  };
  using Button = std::pair<ActionId, const char*>;
  constexpr std::array<Button, 6> kAlign{{{nth(ActionId::first_alignment, 0), "Left"},
                                          {nth(ActionId::first_alignment, 1), "Center"},
                                          {nth(ActionId::first_alignment, 2), "Right"},
                                          {nth(ActionId::first_alignment, 3), "Bottom"},
                                          {nth(ActionId::first_alignment, 4), "Middle"},
                                          {nth(ActionId::first_alignment, 5), "Top"}}};
  constexpr std::array<Button, 2> kDistribute{{{ActionId::distribute_x, "In x"}, {ActionId::distribute_y, "In y"}}};
  constexpr std::array<Button, 2> kMirror{{{ActionId::mirror_x, "In x"}, {ActionId::mirror_y, "In y"}}};
  constexpr std::array<Button, 3> kExactly{{{ActionId::put_on_line, "On a line"},
                                            {ActionId::put_on_circle, "On a circle"},
                                            {ActionId::add_circle, "Circle through 3"}}};
  row("Mirror", kMirror);
  row("Align", kAlign);
  row("Distribute", kDistribute);
  row("Exactly", kExactly);
}

void SelectionPanel::draw_formulas() {
  const SelectionDesk::Numbers numbers = desk_.numbers();
  const char* const explanation =
      "A formula for each by itself. x, y, r: its own numbers; i: its place, from 0; n: how many there are; cx, cy: "
      "the "
      "middle; pi, e, deg. For example cx + 10 * cos(2*pi*i/n)";
  bool is_entered = false;
  const auto field = [&](const char* name, const char* id, std::string& text) {
    label(gui_, name);
    ImGui::SetNextItemWidth(-1.0F);
    is_entered =
        ImGui::InputTextWithHint(id, "a formula for each", &text, ImGuiInputTextFlags_EnterReturnsTrue) || is_entered;
    tooltip(gui_, explanation);
  };
  field("Each x =", "##each-x", each_.x);
  field("Each y =", "##each-y", each_.y);
  if (numbers.balls != 0) field("Each r =", "##each-r", each_.r);
  ImGui::Dummy({0, 0});
  ImGui::SameLine(kLabelWidth * gui_.unit());
  ImGui::BeginDisabled(each_.x.empty() && each_.y.empty() && each_.r.empty());
  if (ImGui::Button("Place each") || is_entered) report(desk_.place_each(each_));
  ImGui::EndDisabled();
  tooltip(gui_, explanation);
}

}  // namespace mes

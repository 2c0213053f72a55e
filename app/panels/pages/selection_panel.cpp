// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/selection_panel.h"

#include <array>

#include "app/layers/words/length_words.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/formula/formula.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kSelectionGap = 4.0F;  // logical pixels
constexpr float kLabelWidth = 72.0F;

void label(const Gui& gui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kLabelWidth * gui.unit());
}

}  // namespace

bool SelectionPanel::report(const Expected<void>& done) {
  if (!done) {
    refusal_.say(done.error());
    return false;
  }
  refusal_.forget();
  if (commands_.numbers().is_in(canvas_.view().free_box())) return true;
  const std::string key = actions_.keymap().key_of(ActionId::fit_selection);
  messages_.remark("The selection lies outside the view: " + descriptor_of(ActionId::fit_selection).name +
                   (key.empty() ? "" : " (" + key + ")") + " shows it");
  return true;
}

void SelectionPanel::enter(const std::string& typed, const Expected<void>& done) {
  if (!report(done)) stay_in_field(typed);
}

void SelectionPanel::number(const char* label, double value, float width, const char* explanation,
                            const std::function<Expected<void>(double)>& use) {
  std::string text;
  ImGui::SetNextItemWidth(width);
  if (exact_field(label, value, text)) {
    const auto number = number_of(text);
    enter(text, number ? use(*number) : std::unexpected(number.error()));
  } else if (ImGui::IsItemDeactivated()) {
    refusal_.forget();  // the refused number is given up
  }
  const bool has_room = ImGui::CalcTextSize(text.c_str()).x <= width - 2 * ImGui::GetStyle().FramePadding.x;
  tooltip(gui_, has_room ? explanation : text + '\n' + explanation);
}

void SelectionPanel::wish(const char* label, const char* hint, std::string& text, const char* button,
                          const char* explanation, const std::function<Expected<void>(double)>& use) {
  const float unit = gui_.unit();
  const float width = ImGui::CalcTextSize(button).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(std::max(40 * unit, ImGui::GetContentRegionAvail().x - width - kSelectionGap * unit));
  const auto act = [&] {
    const auto number = number_of(text);
    return number ? use(*number) : std::unexpected(number.error());
  };
  if (ImGui::InputTextWithHint(label, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue)) enter(text, act());
  tooltip(gui_, explanation);
  ImGui::SameLine(0, kSelectionGap * unit);
  if (ImGui::Button(button)) report(act());
  tooltip(gui_, explanation);
}

void SelectionPanel::action_button(ActionId id, const char* label) {
  ImGui::BeginDisabled(!actions_.is_enabled(id));
  if (ImGui::Button(label)) actions_.run(id);
  ImGui::EndDisabled();
  tooltip(gui_, actions_.tooltip_of(id));
}

void SelectionPanel::draw() {
  const SelectionCommands::Numbers numbers = commands_.numbers();
  if (numbers.samples + numbers.balls == 0) {
    quiet_paragraph(
        "Nothing is selected. Click a sample or a ball, or drag a box around several, to set them by number.");
    return;
  }
  // At a large scale the content is longer than the panel and scrolls below its header.
  if (ImGui::BeginChild("##selection")) {
    ImGui::TextUnformatted(with_unit(counted(numbers.samples, numbers.balls), commands_.map()).c_str());
    tooltip(gui_, commands_.map() ? "Positions and lengths are in this unit" : "");
    draw_place();
    draw_motion();
    if (numbers.samples + numbers.balls > 1) draw_arrangement();
    draw_formulas();
  }
  ImGui::EndChild();
}

void SelectionPanel::draw_place() {
  const SelectionCommands::Numbers numbers = commands_.numbers();
  const float unit = gui_.unit();
  const bool is_one = numbers.samples + numbers.balls == 1;
  label(gui_, is_one ? "Position" : "Middle");
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - kSelectionGap * unit);
  number("##x", numbers.middle.x, half, "x; an expression such as 2/3 or sqrt(2) is computed when the field is left",
         [&](double x) {
           return commands_.move_middle_to({x, numbers.middle.y});
         });
  ImGui::SameLine(0, kSelectionGap * unit);
  number("##y", numbers.middle.y, half, "y; an expression such as 2/3 or sqrt(2) is computed when the field is left",
         [&](double y) {
           return commands_.move_middle_to({numbers.middle.x, y});
         });
  if (numbers.balls == 0) return;
  label(gui_, "Radius");
  number("##r", numbers.radius, half,
         numbers.balls == 1 ? "Radius of the ball" : "Radius of all balls; that of the largest is shown",
         [&](double r) { return commands_.set_radius(r); });
}

void SelectionPanel::draw_motion() {
  const SelectionCommands::Numbers numbers = commands_.numbers();
  const float unit = gui_.unit();
  label(gui_, "Move by");
  const float button = ImGui::CalcTextSize("Move").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float half =
      std::max(30 * unit, 0.5F * (ImGui::GetContentRegionAvail().x - button - 2 * kSelectionGap * unit));
  const auto move = [&]() -> Expected<void> {
    const auto dx = step_x_.empty() ? Expected<double>(0.0) : number_of(step_x_);
    if (!dx) return std::unexpected(dx.error());
    const auto dy = step_y_.empty() ? Expected<double>(0.0) : number_of(step_y_);
    if (!dy) return std::unexpected(dy.error());
    return commands_.move_by({*dx, *dy});
  };
  const auto step = [&](const char* id, const char* hint, std::string& text, const char* explanation) {
    ImGui::SetNextItemWidth(half);
    if (ImGui::InputTextWithHint(id, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue)) enter(text, move());
    tooltip(gui_, explanation);
    ImGui::SameLine(0, kSelectionGap * unit);
  };
  step("##dx", "dx", step_x_, "Step along x");
  step("##dy", "dy", step_y_, "Step along y");
  if (ImGui::Button("Move")) report(move());
  if (numbers.samples + numbers.balls < 2) return;
  label(gui_, "Turn by");
  wish("##degrees", "degrees", degrees_, "Turn", "About the middle, counter-clockwise, in degrees",
       [&](double degrees) { return commands_.turn(degrees); });
  label(gui_, "Scale by");
  wish("##factor", "factor", factor_, "Scale", "About the middle; radii are multiplied, too",
       [&](double factor) { return commands_.scale(factor); });
}

void SelectionPanel::draw_arrangement() {
  const float unit = gui_.unit();
  const auto row = [&](const char* name, std::span<const std::pair<ActionId, const char*>> buttons) {
    label(gui_, name);
    bool is_first = true;
    for (const auto& [id, text] : buttons) {
      if (!is_first) {
        ImGui::SameLine(0, kSelectionGap * unit);
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
                                          {nth(ActionId::first_alignment, 1), "Centre"},
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
  const SelectionCommands::Numbers numbers = commands_.numbers();
  const char* const explanation =
      "A formula for each one. x, y, r: its own numbers; i: its index, from 0; n: how many there are; cx, cy: the "
      "middle; pi, e, deg. For example cx + 10 * cos(2*pi*i/n)";
  const auto field = [&](const char* name, const char* id, std::string& text) {
    label(gui_, name);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::InputTextWithHint(id, "a formula for each", &text, ImGuiInputTextFlags_EnterReturnsTrue))
      enter(text, commands_.place_each(each_));
    tooltip(gui_, explanation);
  };
  field("Each x =", "##each-x", each_.x);
  field("Each y =", "##each-y", each_.y);
  if (numbers.balls != 0) field("Each r =", "##each-r", each_.r);
  ImGui::Dummy({0, 0});
  ImGui::SameLine(kLabelWidth * gui_.unit());
  ImGui::BeginDisabled(each_.x.empty() && each_.y.empty() && each_.r.empty());
  if (ImGui::Button("Place each")) report(commands_.place_each(each_));
  ImGui::EndDisabled();
  tooltip(gui_, explanation);
}

}  // namespace mes

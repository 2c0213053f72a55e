// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/pane_headers.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/layers/words/parameter_words.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr float kHeaderMargin = 8.0F;

ImVec2 frame_on_screen(int x, int y, double pixel_ratio) {
  return {static_cast<float>(x / pixel_ratio), static_cast<float>(y / pixel_ratio)};
}

}  // namespace

void PaneHeaders::draw(const PanePlaces& places) const {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::size_t before = panes.panes().size();
  for (std::size_t i = 0; i < places.places().size(); ++i) {
    const PanePlace& place = places.places()[i];
    list.AddRect(frame_on_screen(place.left, place.top, pixel_ratio),
                 frame_on_screen(place.left + place.width, place.top + place.height, pixel_ratio),
                 gui.colors().border);
    draw_header(i, place);
    // `places` belongs to the panes before the change.
    if (panes.panes().size() != before) return;
  }
}

void PaneHeaders::draw_header(std::size_t pane, const PanePlace& place) const {
  const float unit = gui.unit();
  const ImVec2 corner = frame_on_screen(place.left, place.top + place.height, pixel_ratio);
  ImGui::SetNextWindowPos({corner.x + kHeaderMargin * unit, corner.y - kHeaderMargin * unit}, ImGuiCond_Always,
                          {0.0F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6 * unit, 4 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(fmt::format("##pane-{}", pane).c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const float room = std::max(40 * unit, static_cast<float>(place.width / pixel_ratio) - 6 * kHeaderMargin * unit);
  const std::string text = elided(pane_label(pane, words[pane]), room);
  if (pane == 0) {
    ImGui::TextUnformatted(text.c_str());
    tooltip(gui, "The main pane: shows the layers with the chosen number type and parameters");
  } else {
    if (ImGui::SmallButton(text.c_str())) ImGui::OpenPopup("pane");
    tooltip(gui, "Choose how this pane differs from the main one");
    draw_value(pane - 1);
    draw_step(pane - 1);
    if (begin_popup(gui, "pane")) {
      draw_menu(pane - 1);
      ImGui::EndPopup();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

// Draws a slider for the value of a parameter.
void PaneHeaders::draw_value(std::size_t pane) const {
  const auto* const chosen = std::get_if<ParameterChoice>(&panes.panes()[pane]);
  if (chosen == nullptr || !std::isfinite(chosen->parameter.high)) return;
  const Parameter& descriptor = chosen->parameter;
  double value = chosen->value;
  if (descriptor.is_length) {
    // Its range is that of all coordinates, too wide for a slider.
    ImGui::SetNextItemWidth(230 * gui.unit());
    if (number_field("##value", value, "%.6g", NumberRange{descriptor.low, descriptor.high}))
      panes.change(pane, ParameterChoice{chosen->parameter, value});
    return;
  }
  const bool is_wide = descriptor.low > 0.0 && descriptor.high / descriptor.low > 100.0;
  if (slider(gui, "##value", value, descriptor.low, descriptor.high,
             {.is_logarithmic = is_wide, .is_whole = descriptor.is_whole, .width = 230 * gui.unit()}))
    panes.change(pane, ParameterChoice{chosen->parameter, value});
}

// Draws a slider for the state of the evolution.
void PaneHeaders::draw_step(std::size_t pane) const {
  const auto* const chosen = std::get_if<EvolvedChoice>(&panes.panes()[pane]);
  if (chosen == nullptr) return;
  auto step = static_cast<double>(chosen->step);
  const auto end = static_cast<double>(std::min(std::max(evolution.end(), chosen->step), kMostPaneStep));
  if (slider(gui, "##step", step, 0.0, end, {.is_whole = true, .width = 230 * gui.unit()}))
    panes.change(pane, EvolvedChoice{static_cast<std::uint64_t>(step)});
  tooltip(gui, "Step of the evolution \"" + std::string(evolution.descriptor().name) + "\"");
}

void PaneHeaders::draw_menu(std::size_t pane) const {
  const PaneChoice now = panes.panes()[pane];
  std::optional<PaneChoice> chosen;
  const auto item = [&](const std::string& name, PaneChoice choice, std::string_view explanation = {}) {
    if (ImGui::MenuItem(name.c_str(), nullptr, choice == now)) chosen = std::move(choice);
    if (!explanation.empty()) tooltip(gui, std::string(explanation));
  };
  if (ImGui::BeginMenu("Number type")) {
    for (const PrecisionDescriptor& precision : kPrecisionDescriptors)
      item(std::string(precision.name), precision.precision, precision.explanation);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Parameter")) {
    for (const Parameter& parameter : parameters) {
      const auto* const known = std::get_if<ParameterChoice>(&now);
      const bool is_this = known != nullptr && known->parameter == parameter;
      const double value = is_this ? known->value : settings[parameter];
      item(title_of(parameter), ParameterChoice{parameter, value});
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Balls")) {
    for (const FamilyKind each : kBallFamilies) item(words_of(each), each);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Bundle", !bundles.bundles().empty())) {
    for (const Bundle& bundle : bundles.bundles()) item(bundle.name, bundle, bundle.description);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Document")) {
    item(words_of(BeforeLastEdit{}), BeforeLastEdit{}, "The document as it was before the last undo step");
    const bool is_evolved = std::holds_alternative<EvolvedChoice>(now);
    for (const std::uint64_t step : {0U, 1U, 10U, 50U, 100U})
      item(fmt::format("{}, step {}", evolution.descriptor().name, step), EvolvedChoice{step},
           "This step of the evolution chosen in the window, applied to the present document");
    if (is_evolved) ImGui::TextDisabled("Other steps: the slider beside the menu");
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Add a pane", actions.keymap().key_of(ActionId::add_pane).c_str(), false, !panes.is_full()))
    actions.run(ActionId::add_pane);
  if (ImGui::MenuItem("Close this pane")) {
    panes.close(pane);
    return;
  }
  if (chosen) panes.change(pane, *chosen);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/evolution_strip.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "app/layers/words/parameter_words.h"
#include "app/playing/evolution_layers.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/mark_band.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/color.h"
#include "core/base/rng.h"

namespace mes {
namespace {

constexpr float kChooserWidth = 186;  // logical pixels

/// Puts items side by side while there is room, then on the next line.
class Row {
 public:
  Row(float width, float gap) : end_(ImGui::GetCursorScreenPos().x + width), gap_(gap) {}
  void next(float width) {
    if (!is_first_ && ImGui::GetItemRectMax().x + gap_ + width <= end_) ImGui::SameLine(0, gap_);
    is_first_ = false;
  }

 private:
  float end_;
  float gap_;
  bool is_first_ = true;
};

void chooser(const EvolutionStrip& strip, float most) {
  EvolutionPlayer& player = strip.evolution;
  ImGui::SetNextItemWidth(std::min(kChooserWidth * strip.gui.unit(), most));
  if (ImGui::BeginCombo("##evolution", player.descriptor().name.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const auto& evolution : player.evolutions()) {
      if (ImGui::Selectable(evolution->descriptor.name.c_str(), evolution == player.choice().evolution))
        player.choose(evolution);
      tooltip(strip.gui, evolution->descriptor.tooltip);
    }
    ImGui::EndCombo();
  }
  std::string words = player.descriptor().tooltip;
  const std::string before = strip.actions.keymap().key_of(ActionId::evolution_previous);
  const std::string after = strip.actions.keymap().key_of(ActionId::evolution_next);
  if (!before.empty() && !after.empty()) words += fmt::format(" ({}, {} for another)", before, after);
  tooltip(strip.gui, words);
}

void buttons(const EvolutionStrip& strip, float size) {
  using Direction = EvolutionPlayer::Direction;
  const Direction direction = strip.evolution.direction();
  const auto button = [&](ActionId id, Icon icon, bool on) {
    const bool enabled = strip.actions.is_enabled(id);
    if (icon_button(descriptor_of(id).public_id.data(), icon, size, on ? ButtonLook::on : ButtonLook::plain, enabled))
      strip.actions.run(id);
    tooltip(strip.gui, strip.actions.tooltip_of(id));
    ImGui::SameLine(0, 0);
  };
  button(ActionId::evolution_first, Icon::to_start, false);
  button(ActionId::evolution_back, Icon::step_back, false);
  button(ActionId::evolution_play_back, Icon::play_back, direction == Direction::backward);
  button(ActionId::evolution_stop, Icon::stop, false);
  button(ActionId::evolution_play, Icon::play, direction == Direction::forward);
  button(ActionId::evolution_forward, Icon::step_forward, false);
  ImGui::Dummy({0, size});
}

std::string meaning_of_step(const EvolutionPlayer& player) {
  std::string out = "Number of steps from the beginning";
  if (const auto value = player.parameter_value()) {
    const ParameterMove* const move = player.choice().moved_parameter();
    const bool is_additive = move != nullptr && move->parameter == Parameter::alpha_radius;
    out += fmt::format("\n{} {:.4g}",
                       is_additive ? "A point has grown to a disk of radius" : "Radii are multiplied by", *value);
  }
  return out;
}

/// Draws marks below the slider, which is `width` wide and shows steps up to `end`.
void step_marks(const EvolutionStrip& strip, float width) {
  const StepEvents& events = strip.events;
  const float unit = strip.gui.unit();
  MarkBand marks(strip.gui, "step-marks", width, 8 * unit);
  const auto x_of = [&](std::uint64_t k) {
    return marks.track().at(static_cast<double>(k) / static_cast<double>(strip.evolution.end()));
  };
  std::string words =
      !events.problem().empty() ? "Steps at which the topology changes cannot be found: " + events.problem()
      : !events.are_known()     ? "Looking for steps at which components are joined or holes close"
      : events.events().empty()
          ? "Up to the end of the slider no component is joined and no hole is closed or filled"
          : "Steps at which components are joined (green), holes are closed (purple) or filled (blue); "
            "a click goes to the nearest";
  const StepEvent* nearest = nullptr;
  for (const StepEvent& event : events.events())
    if (marks.mark(x_of(event.k), event.closes != 0  ? palette::purple
                                  : event.fills != 0 ? palette::blue
                                                     : palette::green))
      nearest = &event;
  if (nearest != nullptr) {
    words = nearest->words();
    if (marks.is_clicked()) strip.evolution.step_to(nearest->k);
  }
  marks.explain(words);
}

void slider(const EvolutionStrip& strip, Row& row, float most) {
  EvolutionPlayer& player = strip.evolution;
  const float unit = strip.gui.unit();
  std::uint64_t k = player.target();
  const std::uint64_t end = player.end();
  constexpr float kEnd = 86;
  constexpr float kLeast = 120;
  const bool is_narrow = most < (kLeast + kEnd) * unit;  // then the last step is below the slider
  const float width = std::clamp(is_narrow ? most : most - kEnd * unit, kLeast * unit, 220 * unit);
  row.next(is_narrow ? width : width + kEnd * unit);
  auto step = static_cast<double>(k);
  ImGui::BeginGroup();
  const float rail = slider_rail(strip.gui, width);
  if (slider(strip.gui, "##step", step, 0.0, static_cast<double>(end),
             {.format = "%.0f", .is_whole = true, .width = width}))
    k = static_cast<std::uint64_t>(step);
  if (k != player.target()) player.step_to(k);
  tooltip(strip.gui, meaning_of_step(player));
  if (strip.events.has_place()) {
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + 2 * unit);
    step_marks(strip, rail);
  }
  ImGui::EndGroup();
  if (!is_narrow) ImGui::SameLine(0, 10 * unit);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("of");
  ImGui::SameLine(0, 5 * unit);
  std::uint64_t new_end = end;
  ImGui::SetNextItemWidth(56 * unit);
  if (number_field("##end", new_end, std::max(std::uint64_t{1}, player.target()))) player.set_end(new_end);
  tooltip(strip.gui, "Last step on the slider; playing continues beyond it");
}

void speed(const EvolutionStrip& strip) {
  constexpr std::array<double, 6> kSpeeds{1, 2, 5, 10, 30, EvolutionPlayer::kFastest};
  const auto label = [](double value) {
    return value >= EvolutionPlayer::kFastest ? "Fastest" : fmt::format("{} steps/s", static_cast<int>(value));
  };
  EvolutionPlayer& player = strip.evolution;
  ImGui::SetNextItemWidth(100 * strip.gui.unit());
  if (ImGui::BeginCombo("##speed", label(player.speed()).c_str())) {
    for (const double value : kSpeeds)
      if (ImGui::Selectable(label(value).c_str(), value == player.speed())) player.set_speed(value);
    ImGui::EndCombo();
  }
  tooltip(strip.gui, "Speed of playing; each step waits until the previous picture is complete");
}

void seed(const EvolutionStrip& strip) {
  EvolutionPlayer& player = strip.evolution;
  const float unit = strip.gui.unit();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Seed");
  ImGui::SameLine(0, 5 * unit);
  std::uint64_t value = player.choice().seed;
  ImGui::SetNextItemWidth(70 * unit);
  if (number_field("##seed", value)) player.set_seed(value);
  tooltip(strip.gui, "The same seed always gives the same random numbers");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("New seed")) player.set_seed(Rng(player.choice().seed).at(0) >> 40U);
  tooltip(strip.gui, "Use another seed for other random numbers");
}

void parameter_field(const EvolutionStrip& strip, const Parameter& parameter) {
  EvolutionPlayer& player = strip.evolution;
  const Gui& gui = strip.gui;
  const float unit = gui.unit();
  const std::string title = title_of(parameter);
  const auto choices = parameter.choices;
  double value = player.choice().values[parameter];
  std::optional<double> beyond;
  ImGui::PushID(parameter.id.data());
  if (!choices.empty()) {
    const auto chosen = static_cast<std::size_t>(value);
    ImGui::TextUnformatted(title.c_str());
    ImGui::SetNextItemWidth(250 * unit);
    if (ImGui::BeginCombo("##choice", std::string(choices[chosen]).c_str())) {
      for (std::size_t i = 0; i < choices.size(); ++i)
        if (ImGui::Selectable(std::string(choices[i]).c_str(), i == chosen))
          value = parameter.low + static_cast<double>(i);
      ImGui::EndCombo();
    }
  } else if (parameter.is_length) {
    ImGui::TextUnformatted(title.c_str());
    ImGui::SetNextItemWidth(250 * unit);
    if (number_field("##value", value, "%.6g") && (value < parameter.low || value > parameter.high)) {
      beyond = value;
      value = std::clamp(value, parameter.low, parameter.high);
    }
  } else if (is_switch(parameter)) {
    bool is_on = value != 0.0;
    if (checkbox(title.c_str(), &is_on)) value = is_on ? 1.0 : 0.0;
  } else {
    ImGui::TextUnformatted(title.c_str());
    const std::string number = parameter.unit == "%" ? "%.4g %%" : "%.4g " + std::string(parameter.unit);
    slider(gui, "##value", value, parameter.low, parameter.high,
           {.format = number.c_str(),
            .is_logarithmic = true,
            .is_whole = parameter.is_whole,
            .width = 250 * unit,
            .beyond = &beyond});
  }
  ImGui::PopID();
  if (value != player.choice().values[parameter]) player.set_value(parameter, value);
  if (beyond) strip.messages.remark(beyond_words(title, *beyond, parameter.low, parameter.high));
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().text_quiet);
  paragraph(spoken_explanation(parameter), 330 * unit);
  ImGui::PopStyleColor();
  ImGui::Spacing();
}

// The popup opens above the strip, because the user watches its numbers while changing parameters.
void parameters(const EvolutionStrip& strip, float size) {
  EvolutionPlayer& player = strip.evolution;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (icon_button("parameters", Icon::parameters, size)) ImGui::OpenPopup("##evolution-parameters");
  tooltip(strip.gui, "Parameters\nSettings of this evolution; a change recomputes the present step");
  ImGui::SetNextWindowPos({at.x, ImGui::GetWindowPos().y - 6 * strip.gui.unit()}, ImGuiCond_Appearing, {0.0F, 1.0F});
  if (!begin_popup(strip.gui, "##evolution-parameters")) return;
  const std::vector<Parameter> all = parameters_of(*player.choice().evolution);
  for (const Parameter& parameter : all) parameter_field(strip, parameter);
  if (ImGui::Button("Defaults"))
    for (const Parameter& parameter : all) player.set_value(parameter, parameter.default_value);
  tooltip(strip.gui, "Set every parameter of this evolution to its default");
  ImGui::EndPopup();
}

// Offers the layers of an evolution that nothing on the canvas shows.
void hidden_layers(const EvolutionStrip& strip, Row& row) {
  const std::vector<LayerIndex> wanted =
      layers_to_show(*strip.evolution.choice().evolution, strip.layers, strip.editor.document());
  if (wanted.empty()) return;
  const std::string label = "Show " + strip.evolution.descriptor().moves;
  row.next(ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x);
  if (ImGui::Button(label.c_str()))
    strip.editor.change_layers(label, [&] {
      for (const LayerIndex layer : wanted) strip.layers.set_visible(layer, true);
    });
  tooltip(strip.gui, "No layer is shown that this evolution changes");
}

// Shown for far steps only: for near ones it would flicker.
void draw_progress(const EvolutionStrip& strip, float width) {
  const EvolutionPlayer& player = strip.evolution;
  const bool is_far = player.is_waiting() && player.progress() > 0.0 && player.target() > player.position() + 10;
  const ImVec2 at = ImGui::GetWindowPos();
  if (!is_far) return;
  ImGui::GetWindowDrawList()->AddRectFilled(
      at, {at.x + width * static_cast<float>(player.progress()), at.y + 3 * strip.gui.unit()},
      strip.gui.colors().accent);
}

}  // namespace

float EvolutionStrip::draw(ImVec2 at, float width) const {
  const float unit = gui.unit();
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * unit, 6 * unit});
  ImGui::Begin("##evolution-strip", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  const float size = ImGui::GetFrameHeight();
  Row row(width - 16 * unit, 10 * unit);
  row.next(kChooserWidth * unit);
  chooser(*this, width - 16 * unit);
  row.next(size);
  parameters(*this, size);
  row.next(6 * size);
  buttons(*this, size);
  slider(*this, row, width - 16 * unit);
  row.next(100 * unit);
  speed(*this);
  if (evolution.descriptor().is_random) {
    row.next(190 * unit);
    seed(*this);
  }
  hidden_layers(*this, row);
  draw_progress(*this, ImGui::GetWindowWidth());
  const float height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar();
  return height;
}

}  // namespace mes

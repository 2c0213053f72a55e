// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/evolution_strip.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "app/ui/icons.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"
#include "core/base/rng.h"

namespace mes {
namespace {

/// Puts things side by side while there is room, and then on the next line.
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

void chooser(const EvolutionStrip& strip) {
  EvolutionPlayer& player = strip.evolution;
  ImGui::SetNextItemWidth(104 * strip.gui.unit());
  if (ImGui::BeginCombo("##evolution", player.descriptor().name.data(), ImGuiComboFlags_HeightLarge)) {
    for (EvolutionIndex i = 0; i < evolutions().size(); ++i) {
      const EvolutionDescriptor& evolution = evolutions()[i].descriptor;
      if (ImGui::Selectable(evolution.name.data(), i == player.choice().evolution)) player.choose(i);
      tooltip(strip.gui, std::string(evolution.tooltip));
    }
    ImGui::EndCombo();
  }
  tooltip(strip.gui, std::string(player.descriptor().tooltip) + " (Ctrl+Up, Ctrl+Down for another)");
}

void buttons(const EvolutionStrip& strip, float size) {
  using Direction = EvolutionPlayer::Direction;
  const Direction direction = strip.evolution.direction();
  const auto button = [&](ActionId id, Icon icon, bool on) {
    const bool enabled = strip.actions.is_enabled(id);
    if (icon_button(descriptor_of(id).public_id.data(), icon, size, on ? ButtonLook::on : ButtonLook::plain, enabled))
      strip.actions.run(id);
    tooltip(strip.gui, tooltip_of(id));
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

void slider(const EvolutionStrip& strip, Row& row, float most) {
  EvolutionPlayer& player = strip.evolution;
  const float unit = strip.gui.unit();
  std::uint64_t k = player.target();
  constexpr std::uint64_t kFirst = 0;
  const std::uint64_t end = player.end();
  const float width = std::clamp(most - 86 * unit, 60 * unit, 140 * unit);
  row.next(width + 86 * unit);
  ImGui::SetNextItemWidth(width);
  std::string format = "step %llu";
  if (const auto scale = player.parameter_value()) format += fmt::format(": \u00D7 {:.4g}", *scale);
  if (ImGui::SliderScalar("##step", ImGuiDataType_U64, &k, &kFirst, &end, format.c_str(),
                          ImGuiSliderFlags_AlwaysClamp) &&
      k != player.target())
    player.step_to(k);
  tooltip(strip.gui, "Steps from the beginning; Ctrl+click to type a number");
  ImGui::SameLine(0, 10 * unit);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("of");
  ImGui::SameLine(0, 5 * unit);
  std::uint64_t new_end = end;
  ImGui::SetNextItemWidth(56 * unit);
  if (ImGui::InputScalar("##end", ImGuiDataType_U64, &new_end, nullptr, nullptr, nullptr,
                         ImGuiInputTextFlags_EnterReturnsTrue))
    player.set_end(new_end);
  tooltip(strip.gui, "Last step of the slider; playing goes on beyond it");
}

void speed(const EvolutionStrip& strip) {
  constexpr std::array<double, 6> kSpeeds{1, 2, 5, 10, 30, EvolutionPlayer::kFastest};
  const auto label = [](double value) {
    return value >= EvolutionPlayer::kFastest ? "fastest" : fmt::format("{} a second", static_cast<int>(value));
  };
  EvolutionPlayer& player = strip.evolution;
  ImGui::SetNextItemWidth(100 * strip.gui.unit());
  if (ImGui::BeginCombo("##speed", label(player.speed()).c_str())) {
    for (const double value : kSpeeds)
      if (ImGui::Selectable(label(value).c_str(), value == player.speed())) player.set_speed(value);
    ImGui::EndCombo();
  }
  tooltip(strip.gui, "Steps while playing; never more than pictures can be completed");
}

void seed(const EvolutionStrip& strip) {
  EvolutionPlayer& player = strip.evolution;
  const float unit = strip.gui.unit();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Seed");
  ImGui::SameLine(0, 5 * unit);
  std::uint64_t value = player.choice().seed;
  ImGui::SetNextItemWidth(70 * unit);
  if (ImGui::InputScalar("##seed", ImGuiDataType_U64, &value, nullptr, nullptr, nullptr,
                         ImGuiInputTextFlags_EnterReturnsTrue))
    player.set_seed(value);
  tooltip(strip.gui, "The same seed gives the same random numbers, always");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("New seed")) player.set_seed(Rng(player.choice().seed).at(0) >> 40U);
  tooltip(strip.gui, "Draw other random numbers");
}

void parameter_field(const EvolutionStrip& strip, const ParameterDescriptor& parameter) {
  EvolutionPlayer& player = strip.evolution;
  const std::string id(parameter.id);
  double value = player.choice().values[parameter.id];
  ImGui::SetNextItemWidth(140 * strip.gui.unit());
  if (parameter.is_whole && parameter.high == 1.0) {
    bool is_on = value != 0.0;
    if (ImGui::Checkbox(id.c_str(), &is_on)) player.set_value(parameter.id, is_on ? 1.0 : 0.0);
  } else if (parameter.is_whole) {
    auto whole = static_cast<int>(value);
    if (ImGui::SliderInt(id.c_str(), &whole, static_cast<int>(parameter.low), static_cast<int>(parameter.high), "%d",
                         ImGuiSliderFlags_AlwaysClamp))
      player.set_value(parameter.id, whole);
  } else if (ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &parameter.low, &parameter.high, "%.4g",
                                 ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
    player.set_value(parameter.id, value);
  }
  ImGui::PushStyleColor(ImGuiCol_Text, strip.gui.colors().text_quiet);
  ImGui::PushTextWrapPos(330 * strip.gui.unit());
  ImGui::TextUnformatted(parameter.explanation.data());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Spacing();
}

void parameters(const EvolutionStrip& strip, float size) {
  EvolutionPlayer& player = strip.evolution;
  if (icon_button("parameters", Icon::parameters, size)) ImGui::OpenPopup("##evolution-parameters");
  tooltip(strip.gui, "Parameters\nWhat steers this evolution; a change shows the present step anew");
  if (!ImGui::BeginPopup("##evolution-parameters")) return;
  const std::vector<ParameterDescriptor> all = parameters_of(player.choice().evolution);
  for (const ParameterDescriptor& parameter : all) parameter_field(strip, parameter);
  if (ImGui::Button("As at the beginning"))
    for (const ParameterDescriptor& parameter : all) player.set_value(parameter.id, parameter.default_value);
  tooltip(strip.gui, "Give every parameter of this evolution its first value back");
  ImGui::EndPopup();
}

// Far steps only: for near ones it would flicker.
void progress(const EvolutionStrip& strip, float width) {
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
  row.next(104 * unit);
  chooser(*this);
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
  progress(*this, ImGui::GetWindowWidth());
  const float height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar();
  return height;
}

}  // namespace mes

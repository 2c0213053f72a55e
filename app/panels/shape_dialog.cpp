// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/shape_dialog.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "app/ui/large_dialog.h"
#include "app/ui/slider.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kShapeDialogWidth = 1040.0F;  // logical pixels
constexpr float kShapeDialogHeight = 600.0F;
constexpr float kShapeListWidth = 190.0F;
constexpr float kShapeSettingsWidth = 300.0F;
constexpr const char* kShapeDialogId = "##shape";

/// Ranges of a slider: around the default where the parameter may be anything.
struct SliderRange {
  double low;
  double high;
  bool is_logarithmic;
};
SliderRange range_of(const Parameter& parameter) {
  constexpr double kWide = 100.0;
  constexpr double kFactor = 20.0;
  const double value = parameter.default_value;
  if (parameter.high - parameter.low < kWide) return {parameter.low, parameter.high, false};
  if (parameter.is_whole && parameter.low >= 0.0)
    return {parameter.low, std::max(4.0 * value, parameter.low + 2.0 * kFactor), false};
  if (parameter.low > 0.0) return {value / kFactor, value * kFactor, true};
  return {std::max(parameter.low, value - kFactor), std::min(parameter.high, value + kFactor), false};
}

}  // namespace

void ShapeDialog::open() {
  is_open_ = !shapes_->all().empty();
  if (values_.empty())
    for (const auto& shape : shapes_->all()) values_.push_back(values_of(*shape));
}

void ShapeDialog::press(const KeyChord& chord) {
  if (chord.symbol == key::enter && !ImGui::IsAnyItemActive()) maker_.accept();
}

void ShapeDialog::draw_list(const Gui& gui) {
  for (std::size_t i = 0; i < shapes_->all().size(); ++i) {
    const ShapeDescriptor& one = *shapes_->all()[i];
    if (ImGui::Selectable(std::string(one.name).c_str(), i == chosen_)) chosen_ = i;
    tooltip(gui, std::string(one.explanation));
  }
}

void ShapeDialog::draw_parameters(const Gui& gui) {
  const float width = ImGui::GetContentRegionAvail().x;
  ShapeValues& values = values_[chosen_];
  ImGui::PushID(static_cast<int>(chosen_));
  for (std::size_t i = 0; i < shape().formulas.size(); ++i) {
    const FormulaParameter& formula = shape().formulas[i];
    ImGui::TextUnformatted(formula.id.c_str());
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(fmt::format("##{}", formula.id).c_str(), &values.formulas[i]);
    tooltip(gui, formula.explanation);
  }
  for (const Parameter& parameter : shape().parameters) {
    const SliderRange range = range_of(parameter);
    ImGui::TextUnformatted(parameter.id.c_str());
    slider(gui, fmt::format("##{}", parameter.id).c_str(), values.numbers[parameter], range.low, range.high,
           {.format = parameter.is_whole ? "%.0f" : "%.4g",
            .is_logarithmic = range.is_logarithmic,
            .is_whole = parameter.is_whole,
            .width = width,
            .typed = SliderLook::Range{parameter.low, parameter.high}});
    tooltip(gui, parameter.explanation);
  }
  ImGui::PopID();
}

const ShapeDescriptor& ShapeDialog::shape() const {
  return *shapes_->all()[chosen_];
}

void ShapeDialog::follow_wish() {
  ShapeRequest request{.values = values_[chosen_], .sampling = sampling_.sampling()};
  if (wished_of_ == chosen_ && wished_for_ == request) return;
  maker_.want([chosen = &shape(), request](JobControl& job) {
    return SampleMaking::Made{make_shape(*chosen, request, &job)};
  });
  wished_for_ = std::move(request);
  wished_of_ = chosen_;
}

void ShapeDialog::draw(const Gui& gui) {
  large_dialog(gui, kShapeDialogId, is_open_, {kShapeDialogWidth, kShapeDialogHeight}, [&](ImVec2 size) {
    const float unit = gui.unit();
    ImGui::BeginChild("shapes", {std::min(kShapeListWidth * unit, 0.25F * size.x), 0});
    draw_list(gui);
    ImGui::EndChild();
    ImGui::SameLine(0, 12 * unit);
    ImGui::BeginChild("settings", {std::min(kShapeSettingsWidth * unit, 0.35F * size.x), 0});
    ImGui::PushFont(gui.bold());
    ImGui::TextUnformatted(shape().name.c_str());
    ImGui::PopFont();
    ImGui::BeginChild("choices", {0, -ImGui::GetFrameHeightWithSpacing()});
    draw_parameters(gui);
    ImGui::Dummy({1, 2 * unit});
    sampling_.draw(gui);
    follow_wish();
    maker_.draw_facts(gui);
    ImGui::EndChild();
    if (maker_.draw_buttons(gui, std::string(shape().name), "The shape becomes a document of its own")) cancel();
    ImGui::EndChild();
    ImGui::SameLine(0, 16 * unit);
    ImGui::BeginChild("preview");
    maker_.draw_preview(gui);
    ImGui::EndChild();
  });
}

}  // namespace mes

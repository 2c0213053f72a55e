// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/shape_dialog.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/dialogs/large_dialog.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kShapeDialogWidth = 1040.0F;  // logical pixels
constexpr float kShapeDialogHeight = 600.0F;
constexpr float kShapeListWidth = 190.0F;
constexpr float kShapeSettingsWidth = 300.0F;
constexpr const char* kShapeDialogId = "##shape";

/// The range of a slider: around the default if the parameter may be anything.
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
  is_open_ = follow_registry();
}

bool ShapeDialog::follow_registry() {
  std::shared_ptr<const ShapeDescriptor> shape = registry_->now().shapes().find(chosen_id_);
  if (!shape && !shapes().empty()) shape = shapes().front();
  if (!shape) return false;
  chosen_id_ = shape->id;
  chosen_ = &choices_[chosen_id_];
  if (chosen_->shape == shape) return true;
  // Keeps the values of parameters that the replacing shape has, too.
  ShapeValues values = values_of(*shape);
  if (chosen_->shape)
    for (const Parameter& parameter : shape->parameters)
      values.numbers[parameter] = within(parameter, chosen_->values.numbers[parameter]);
  *chosen_ = {std::move(shape), std::move(values)};
  return true;
}

void ShapeDialog::press(const KeyChord& chord) {
  if (chord.symbol == key::enter && !ImGui::IsAnyItemActive()) maker_.accept();
}

void ShapeDialog::draw_list(const Gui& gui) {
  for (const auto& one : shapes()) {
    const bool is_chosen = ImGui::Selectable(one->name.c_str(), one->id == chosen_id_);
    if (one->id == chosen_id_) ImGui::SetItemDefaultFocus();
    if (is_chosen || is_marked_by_key()) chosen_id_ = one->id;
    tooltip(gui, one->explanation);
  }
  follow_registry();
}

void ShapeDialog::draw_parameters(const Gui& gui) {
  const float width = ImGui::GetContentRegionAvail().x;
  ShapeValues& values = chosen_->values;
  const ShapeDescriptor& shape = *chosen_->shape;
  ImGui::PushID(chosen_id_.c_str());
  for (std::size_t i = 0; i < shape.formulas.size(); ++i) {
    const FormulaParameter& formula = shape.formulas[i];
    ImGui::TextUnformatted(formula.id.c_str());
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(fmt::format("##{}", formula.id).c_str(), &values.formulas[i]);
    tooltip(gui, formula.explanation);
  }
  for (const Parameter& parameter : shape.parameters) {
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

void ShapeDialog::follow_wish() {
  ShapeRequest request{.values = chosen_->values, .sampling = sampling_.sampling()};
  if (wished_of_ == chosen_->shape && wished_for_ == request) return;
  maker_.want([registry = registry_->share(), shape = chosen_->shape, request](JobControl& job) {
    return SampleMaking::Made{make_shape(*shape, request, &job)};
  });
  wished_for_ = std::move(request);
  wished_of_ = chosen_->shape;
}

void ShapeDialog::draw(const Gui& gui) {
  if (is_open_ && !follow_registry()) cancel();
  large_dialog(
      gui, kShapeDialogId, is_open_, {kShapeDialogWidth, kShapeDialogHeight}, DialogKeys::controls, [&](ImVec2) {
        const DialogColumn columns[] = {{"shapes", kShapeListWidth, [&] { draw_list(gui); }},
                                        {"settings", kShapeSettingsWidth,
                                         [&] {
                                           heading(gui, chosen_->shape->name);
                                           draw_parameters(gui);
                                           ImGui::Dummy({1, 2 * gui.unit()});
                                           sampling_.draw(gui);
                                           follow_wish();
                                           maker_.draw_facts(gui);
                                         }},
                                        {"preview", 0, [&] { maker_.draw_preview(gui); }}};
        dialog_columns(
            gui, columns,
            maker_.foot(gui, chosen_->shape->name, "The shape becomes a new document", [this] { cancel(); }));
      });
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/layers/color_map_controls.h"

#include <algorithm>

#include "app/layers/words/scalar_words.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr float kPreviewWidth = 90.0F;
constexpr float kColorMapFieldWidth = 78.0F;
constexpr std::size_t kCategoriesShown = 9;

void set_range(LayerStyle& style, const render::ScalarRange& range) {
  style.range_locked = true;
  style.range_low = range.low;
  style.range_high = std::max(range.low, range.high);
}

}  // namespace

void draw_color_map(ImDrawList& list, const render::ColorMap& map, ImVec2 at, ImVec2 size, double opacity) {
  const std::size_t steps = map.is_categorical ? std::min(kCategoriesShown, map.colors.size()) : 32;
  for (std::size_t i = 0; i < steps; ++i) {
    const auto place = [&](std::size_t k) {
      return at.x + size.x * static_cast<float>(k) / static_cast<float>(steps);
    };
    const ImVec2 from(place(i), at.y);
    const ImVec2 to(place(i + 1), at.y + size.y);
    if (map.is_categorical) {
      list.AddRectFilled(from, to, to_imgui(*map.color_of(static_cast<double>(i), {}), opacity));
      continue;
    }
    const auto color = [&](std::size_t k) {
      return to_imgui(map.at(static_cast<double>(k) / static_cast<double>(steps)), opacity);
    };
    list.AddRectFilledMultiColor(from, to, color(i), color(i + 1), color(i + 1), color(i));
  }
}

void ColorMapControls::draw_choice(LayerStyle& style) const {
  const float unit = gui_.unit();
  const std::string shown = style.color_map.empty() ? "One colour" : style.color_map;
  ImGui::SetNextItemWidth(150 * unit);
  if (ImGui::BeginCombo("Colour map", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    if (ImGui::Selectable("One colour", style.color_map.empty())) style.color_map.clear();
    for (const render::ColorMap& map : picture_.scene().color_maps()) {
      ImGui::PushID(map.name.c_str());
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float height = ImGui::GetTextLineHeight();
      const ImVec2 row(kPreviewWidth * unit + 12 * unit + ImGui::CalcTextSize(map.name.c_str()).x, height);
      if (ImGui::Selectable("##map", style.color_map == map.name, 0, row)) style.color_map = map.name;
      ImDrawList& list = *ImGui::GetWindowDrawList();
      draw_color_map(list, map, at, {kPreviewWidth * unit, height});
      list.AddText({at.x + kPreviewWidth * unit + 8 * unit, at.y}, gui_.colors().text, map.name.c_str());
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
}

void ColorMapControls::draw_range(LayerIndex layer, LayerStyle& style) {
  const float unit = gui_.unit();
  const render::ScalarRange now = picture_.scene().scalar_range(layer);
  render::ScalarRange range = style.range_locked ? render::ScalarRange{style.range_low, style.range_high} : now;
  if (range.is_empty()) range = {0.0, 1.0};
  const auto field = [&](const char* label, double& value) {
    ImGui::SetNextItemWidth(kColorMapFieldWidth * unit);
    return number_field(label, value, "%.5g");
  };
  double low = range.low;
  double high = range.high;
  if (field("##low", low)) set_range(style, {low, std::max(low, range.high)});
  tooltip(gui_, "Value of the first colour of the map; a number typed here locks the range");
  ImGui::SameLine(0, 4 * unit);
  if (field("##high", high)) set_range(style, {std::min(range.low, high), high});
  tooltip(gui_, "Value of the last colour of the map; a number typed here locks the range");
  ImGui::SameLine(0, 6 * unit);
  bool locked = style.range_locked;
  if (checkbox("Lock", &locked)) {
    if (locked)
      set_range(style, range);
    else
      style.range_locked = false;
  }
  tooltip(gui_, "Keep this range; otherwise it follows the values shown");
  ImGui::BeginDisabled(now.is_empty());
  if (ImGui::Button("Fit now")) set_range(style, now);
  ImGui::EndDisabled();
  tooltip(gui_, "Lock the range to the values shown now");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::Button("Copy range")) copied_ = range;
  tooltip(gui_, "Copy this range, to use it for another layer");
  ImGui::SameLine(0, 4 * unit);
  ImGui::BeginDisabled(!copied_.has_value());
  if (ImGui::Button("Paste range") && copied_) set_range(style, *copied_);
  ImGui::EndDisabled();
  tooltip(gui_, "Use the copied range for this layer");
}

void ColorMapControls::draw_selection(LayerIndex layer) {
  const float unit = gui_.unit();
  const render::ScalarRange now = picture_.scene().scalar_range(layer);
  if (!select_ || now.is_empty()) return;
  // Such values are from another document if no element has them any more.
  std::erase_if(wanted_, [&](const auto& typed) {
    return typed.first == layer && (typed.second.low > now.high || typed.second.high < now.low);
  });
  const auto typed = wanted_.find(layer);
  render::ScalarRange range = typed == wanted_.end() ? now : typed->second;
  const auto field = [&](const char* label, double& value) {
    ImGui::SetNextItemWidth(kColorMapFieldWidth * unit);
    return number_field(label, value, "%.5g");
  };
  const bool has_low = field("##from", range.low);
  tooltip(gui_, "The least value to be selected");
  ImGui::SameLine(0, 4 * unit);
  const bool has_high = field("##to", range.high);
  tooltip(gui_, "The largest value to be selected");
  if (has_low || has_high) wanted_[layer] = range;
  ImGui::SameLine(0, 6 * unit);
  if (ImGui::Button("Select by value")) select_(layer, range.low, range.high);
  tooltip(gui_, "Select the samples or balls that the elements with a value in this range derive from");
}

void ColorMapControls::draw(LayerIndex layer, LayerStyle& style) {
  const std::string_view scalar = layers_.descriptor(layer).scalar;
  if (scalar.empty()) return;
  draw_choice(style);
  tooltip(gui_, "Colours by " + spoken_scalar(scalar));
  if (!style.color_map.empty()) draw_range(layer, style);
  draw_selection(layer);
}

}  // namespace mes

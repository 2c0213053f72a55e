// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/slider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "app/ui/widgets/number_field.h"

namespace mes {
namespace {

constexpr float kGap = 4.0F;  // logical pixels
constexpr float kField = 76.0F;

/// A number that looks like an end of the range is taken as that end.
std::optional<std::string> fault_of(double number, const NumberRange& range, const SliderLook& look) {
  const auto shown = [&look](double value) {
    std::array<char, 64> out{};
    std::snprintf(out.data(), out.size(), look.format, value);
    return std::string(out.data());
  };
  const bool is_end = shown(number) == shown(range.low) || shown(number) == shown(range.high);
  if (is_end && !range.is_whole) return std::nullopt;
  return look.beyond != nullptr ? range_fault(number, {.is_whole = range.is_whole}) : range_fault(number, range);
}

}  // namespace

float slider_rail(const Gui& gui, float width) {
  return std::max(30 * gui.unit(), width - (kField + kGap) * gui.unit());
}

// The distance of the grip from the ends as in Dear ImGui.
SliderTrack::SliderTrack(float left, float width) {
  constexpr float kPadding = 2.0F;
  const float margin =
      kPadding + 0.5F * std::min(ImGui::GetStyle().GrabMinSize, std::max(0.0F, width - 2 * kPadding));
  from_ = left + margin;
  length_ = std::max(0.0F, width - 2 * margin);
}

double SliderTrack::part_at(float x) const {
  return length_ > 0.0F ? std::clamp(static_cast<double>((x - from_) / length_), 0.0, 1.0) : 0.0;
}

bool slider(const Gui& gui, const char* label, double& value, double low, double high, const SliderLook& look) {
  const float gap = kGap * gui.unit();
  const double before = value;
  ImGui::PushID(label);
  ImGui::BeginGroup();
  const float width = look.width > 0.0F ? look.width : ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(slider_rail(gui, width));
  const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput |
                                 (look.is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  if (look.end > 0.0) {
    // The slider shows the square root of the number.
    constexpr double kLeast = 0.0;
    constexpr double kMost = 1.0;
    double root = std::sqrt(std::clamp(value / look.end, kLeast, kMost));
    if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &root, &kLeast, &kMost, "", flags))
      value = look.end * root * root;
  } else {
    double shown = value;
    if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &shown, &low, &high, "", flags)) value = shown;
  }
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(kField * gui.unit());
  if (look.takes_keyboard) ImGui::SetKeyboardFocusHere();
  double typed = value;
  const SliderLook::Range range = look.typed.value_or(SliderLook::Range{low, high});
  const bool is_typed = number_field("##number", typed, look.format, [&](double number) {
    return fault_of(number, {range.low, range.high, look.is_whole}, look);
  });
  if (is_typed) value = typed;
  const std::string_view text(label);
  if (const std::string_view words = text.substr(0, text.find("##")); !words.empty()) {
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
  }
  ImGui::EndGroup();
  ImGui::PopID();
  if (value == before) return false;
  if (look.is_whole) value = std::round(value);
  if (is_typed && look.beyond != nullptr && (value < range.low || value > range.high)) *look.beyond = typed;
  value = std::clamp(value, range.low, range.high);
  return value != before;
}

}  // namespace mes

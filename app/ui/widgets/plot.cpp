// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/plot.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>

#include "app/ui/screen/theme.h"
#include "core/io/text/round_numbers.h"

namespace mes {
namespace {

// Logical pixels.
constexpr float kNumbersApart = 44.0F;
constexpr float kRowsApart = 34.0F;
constexpr float kTickGap = 4.0F;

/// The position of a value along the axis, from 0 to 1.
double part_of(const PlotAxis& axis, double value) {
  const double part = std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
  return axis.is_root ? std::sqrt(part) : part;
}

}  // namespace

std::vector<PlotTick> plot_ticks(const PlotAxis& axis, double length, double apart) {
  const double range = axis.high - axis.low;
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  // Doubles must distinguish the numbers.
  constexpr double kStepsPerNumber = 64.0;
  if (!(range > kStepsPerNumber * std::numeric_limits<double>::epsilon() * largest) || !std::isfinite(range) ||
      !(length > 0.0))
    return {};
  std::vector<PlotTick> out;
  if (axis.is_root) {
    out.push_back({0.0, "0"});
    // A quarter of a number is half as far away.
    std::vector<double> values;
    for (double value = round_number_up_to(axis.high); value > 0.0; value = round_number_up_to(0.4 * value)) {
      const double at = length * part_of(axis, value);
      if (at < apart) break;
      if (values.empty() || length * part_of(axis, values.back()) - at >= apart) values.push_back(value);
    }
    std::ranges::reverse(values);
    for (const double value : values) out.push_back({value, number_text(value, value)});
    return out;
  }
  const double step = round_number_from(range * std::min(1.0, apart / length));
  if (!(step > kStepsPerNumber * std::numeric_limits<double>::epsilon() * largest)) return {};
  for (double i = std::ceil(axis.low / step); i * step <= axis.high; i += 1.0)
    out.push_back({i * step, number_text(i * step, step)});
  return out;
}

Plot::Plot(const Gui& gui, const PanelArea& area, PlotAxis x, PlotAxis y, bool is_large)
    : gui_(gui),
      area_(area),
      x_(std::move(x)),
      y_(std::move(y)),
      is_large_(is_large),
      font_(is_large ? ImGui::GetFont() : gui.small()) {
  const float unit = gui_.unit();
  ImGui::PushFont(font_);
  const float line = ImGui::GetTextLineHeight();
  const float edge = (is_large_ ? 14 : 6) * unit;
  const float title = line + 4 * unit;
  if (y_.above) room_above_ = ImGui::GetTextLineHeight() + 4 * unit;
  const float top = edge + title + room_above_;
  const float bottom = edge + kTickGap * unit + line + title;
  const float height = std::max(1.0F, area.size.y - top - bottom);
  y_ticks_ = plot_ticks(y_, static_cast<double>(height), static_cast<double>(kRowsApart * unit));
  float numbers = 0.0F;
  for (const PlotTick& tick : y_ticks_) numbers = std::max(numbers, ImGui::CalcTextSize(tick.text.c_str()).x);
  if (y_.above) numbers = std::max(numbers, ImGui::CalcTextSize(y_.above->c_str()).x);
  const float left = edge + numbers + kTickGap * unit;
  const float right = edge + 8 * unit;
  inside_ = {{area.at.x + left, area.at.y + top}, {std::max(1.0F, area.size.x - left - right), height}};
  x_ticks_ = plot_ticks(x_, static_cast<double>(inside_.size.x), static_cast<double>(kNumbersApart * unit));
  ImGui::PopFont();
}

float Plot::x_of(double value) const {
  return inside_.at.x + inside_.size.x * static_cast<float>(part_of(x_, value));
}

float Plot::y_of(double value) const {
  return inside_.at.y + inside_.size.y * (1.0F - static_cast<float>(part_of(y_, value)));
}

double Plot::x_at(float position) const {
  const double part = std::clamp(static_cast<double>((position - inside_.at.x) / inside_.size.x), 0.0, 1.0);
  return x_.low + (x_.high - x_.low) * (x_.is_root ? part * part : part);
}

void Plot::draw_frame(ImDrawList& list) const {
  const float unit = gui_.unit();
  const float thin = std::max(1.0F, unit);
  const ImVec2 low = inside_.at;
  const ImVec2 high(low.x + inside_.size.x, low.y + inside_.size.y);
  list.AddRectFilled(area_.at, {area_.at.x + area_.size.x, area_.at.y + area_.size.y}, IM_COL32_WHITE);
  const float size = font_->FontSize * ImGui::GetIO().FontGlobalScale;
  const auto width_of = [&](const std::string& text) {
    return font_->CalcTextSizeA(size, FLT_MAX, 0.0F, text.c_str()).x;
  };
  constexpr ImU32 kGrid = IM_COL32(0, 0, 0, 24);
  list.PushClipRect(area_.at, {area_.at.x + area_.size.x, area_.at.y + area_.size.y}, true);
  for (const PlotTick& tick : x_ticks_) {
    const float x = x_of(tick.value);
    list.AddLine({x, low.y}, {x, high.y}, kGrid, thin);
    list.AddText(font_, size, {x - 0.5F * width_of(tick.text), high.y + kTickGap * unit}, kQuietInk,
                 tick.text.c_str());
  }
  for (const PlotTick& tick : y_ticks_) {
    const float y = y_of(tick.value);
    list.AddLine({low.x, y}, {high.x, y}, kGrid, thin);
    list.AddText(font_, size, {low.x - kTickGap * unit - width_of(tick.text), y - 0.5F * size}, kQuietInk,
                 tick.text.c_str());
  }
  if (y_.above && !y_.above->empty()) {
    list.AddLine({low.x, above()}, {high.x, above()}, kQuietInk, thin);
    list.AddText(font_, size, {low.x - kTickGap * unit - width_of(*y_.above), above() - 0.5F * size}, kQuietInk,
                 y_.above->c_str());
  }
  list.AddLine({low.x, top()}, {low.x, high.y}, kQuietInk, thin);
  list.AddLine({low.x, high.y}, {high.x, high.y}, kQuietInk, thin);
  list.AddText(font_, size, {low.x, top() - size - 6 * unit}, kInk, y_.title.c_str());
  list.AddText(font_, size, {high.x - width_of(x_.title), high.y + 2 * kTickGap * unit + size}, kInk,
               x_.title.c_str());
  list.PopClipRect();
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/circle_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mes::render {

RowRange CircleField::rows_of(const PixelDisk& circle) const {
  const double top = height();
  const double reach = circle.radius + reach_;
  const double first = std::clamp(circle.y - reach - 0.5, 0.0, top);
  const double end = std::clamp(circle.y + reach + 0.5, 0.0, top);
  const bool is_beside = circle.x + reach < 0.0 || circle.x - reach > static_cast<double>(width());
  return is_beside ? RowRange{} : RowRange{static_cast<int>(first), static_cast<int>(end)};
}

void CircleField::change(std::span<const PixelDisk> circles, int sign) {
  change_by_bands(
      circles, [this](const PixelDisk& circle) { return rows_of(circle); },
      [&](const PixelDisk& circle, RowRange rows) { change_rows(circle, sign * std::int64_t{circle.times}, rows); });
}

void CircleField::change_rows(const PixelDisk& circle, std::int64_t times, RowRange rows) {
  const double outer = circle.radius + reach_;
  const double inner = std::max(circle.radius - reach_, 0.0);
  const double most = width();
  const double x = circle.x - 0.5;
  for (int y = rows.first; y < rows.end; ++y) {
    const double dy = y + 0.5 - circle.y;
    const double outer_square = outer * outer - dy * dy;
    if (outer_square <= 0.0) continue;
    const double half = std::sqrt(outer_square);
    const double inner_square = inner * inner - dy * dy;
    const double hole = inner_square > 0.0 ? std::sqrt(inner_square) : 0.0;
    // Truncation rounds down, and may include one untouched pixel at each end. Both parts meet in a row without a hole.
    const auto left = static_cast<int>(std::clamp(x - half, 0.0, most));
    const auto left_end = static_cast<int>(std::clamp(x - hole + 1.0, 0.0, most));
    const auto right = std::max(static_cast<int>(std::clamp(x + hole, 0.0, most)), left_end);
    const auto right_end = static_cast<int>(std::clamp(x + half + 1.0, 0.0, most));
    change_pixels(circle, times, y, left, left_end);
    change_pixels(circle, times, y, right, right_end);
  }
  mark(rows);
}

// Four pixels at a time: loops without branches, which compilers vectorise. The distance from the rim is
// (d^2 - r^2) / (d + r). The difference is computed in double for the first of the four pixels, and from there in
// single precision: what that loses is divided by 2 r, so it is a millionth of a pixel for circles of any size.
void CircleField::change_pixels(const PixelDisk& circle, std::int64_t times, int y, int begin, int end) {
  constexpr int kPixels = 4;
  constexpr float kTiny = 1e-6F;  // no division by zero in the centre of a point
  const double dy = y + 0.5 - circle.y;
  const double offset = dy * dy - circle.radius * circle.radius;
  const auto square = static_cast<float>(circle.radius * circle.radius);
  const auto radius = static_cast<float>(circle.radius);
  const auto reach = static_cast<float>(reach_);
  std::int64_t* sum = sums(y);
  for (int x = begin; x < end; x += kPixels) {
    const double dx = x + 0.5 - circle.x;
    const auto difference = static_cast<float>(dx * dx + offset);
    const auto slope = static_cast<float>(2.0 * dx);
    std::array<std::int32_t, kPixels> steps{};
    for (std::size_t k = 0; k < kPixels; ++k) {
      const auto right = static_cast<float>(static_cast<std::int32_t>(k));
      const float power = difference + right * (slope + right);
      const float distance_square = power + square;
      const float distance = std::sqrt(distance_square > 0.0F ? distance_square : 0.0F);
      const float covered = reach - std::abs(power / (distance + radius + kTiny));
      const float above = covered > 0.0F ? covered : 0.0F;
      steps[k] = static_cast<std::int32_t>((above < 1.0F ? above : 1.0F) * kSteps + kHalfStep);
    }
    const int count = std::min(kPixels, end - x);
    for (int k = 0; k < count; ++k)
      sum[x + k] += times * factor(static_cast<std::size_t>(steps[static_cast<std::size_t>(k)]));
  }
}

}  // namespace mes::render

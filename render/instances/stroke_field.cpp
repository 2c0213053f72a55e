// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/stroke_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mes::render {
namespace {

// Branch-free, because random strokes would cause mispredicted branches.
double smaller(double a, double b) {
  return a < b ? a : b;
}
double larger(double a, double b) {
  return a > b ? a : b;
}
double between(double x, double low, double high) {
  return smaller(larger(x, low), high);
}

}  // namespace

std::optional<PixelStroke> StrokeField::visible(Vec2 from, Vec2 to, double width, double height, double half_width) {
  // Cut ends, including their round caps, are outside of the view.
  const double margin = half_width + 2.0;
  const Vec2 low{-margin, -margin};
  const Vec2 high{width + margin, height + margin};
  const auto is_inside = [&](Vec2 p) { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; };
  Vec2 a = from;
  Vec2 b = to;
  if (!is_inside(a) || !is_inside(b)) {
    // Most invisible strokes lie to one side of the view.
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x || std::max(a.y, b.y) < low.y ||
        std::min(a.y, b.y) > high.y)
      return std::nullopt;
    double t0 = 0.0;
    double t1 = 1.0;
    const Vec2 step = to - from;
    // Cuts between two parallel edges of the view; false for NaN, too.
    const auto cut = [&](double start, double slope, double least, double most) {
      if (slope == 0.0) return start >= least && start <= most;
      const double s = (least - start) / slope;
      const double t = (most - start) / slope;
      t0 = std::max(t0, std::min(s, t));
      t1 = std::min(t1, std::max(s, t));
      return t0 <= t1;
    };
    if (!cut(from.x, step.x, low.x, high.x) || !cut(from.y, step.y, low.y, high.y)) return std::nullopt;
    if (t0 > 0.0) a = from + t0 * step;
    if (t1 < 1.0) b = from + t1 * step;
  }
  return PixelStroke{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x),
                     static_cast<float>(b.y), 1};
}

void StrokeField::change(std::span<const PixelStroke> strokes, int sign) {
  change_by_bands(
      strokes, [this](const PixelStroke& stroke) { return rows_of(stroke); },
      [&](const PixelStroke& stroke, RowRange rows) { change_rows(stroke, sign, rows); });
}

void StrokeField::change_rows(const PixelStroke& stroke, int sign, RowRange rows) {
  const double dx = double{stroke.to_x} - double{stroke.x};
  const double dy = double{stroke.to_y} - double{stroke.y};
  const double size = std::sqrt(dx * dx + dy * dy);
  // Unit vector along the stroke.
  const double ux = size > 0.0 ? dx / size : 1.0;
  const double uy = size > 0.0 ? dy / size : 0.0;
  const double low = std::min(dx, 0.0) - reach_;
  const double high = std::max(dx, 0.0) + reach_;
  // Half the width in a row of the infinite strip along the stroke; the whole range if the stroke hardly rises.
  const bool is_steep = std::abs(uy) * (high - low) > reach_;
  const double strip = is_steep ? reach_ / std::abs(uy) : high - low;
  const double slope = is_steep ? ux / uy : 0.0;
  const double first_center = 0.5 - double{stroke.x};
  const double most = width();
  const auto reach = static_cast<float>(reach_);
  // Four pixels at a time: loops without branches, which compilers vectorise. Distances are computed in double for the
  // first of the four pixels, and from there in single precision.
  constexpr int kPixels = 4;
  std::array<float, kPixels> along{};
  std::array<float, kPixels> across{};
  for (int k = 0; k < kPixels; ++k) {
    along[static_cast<std::size_t>(k)] = static_cast<float>(k * ux);
    across[static_cast<std::size_t>(k)] = static_cast<float>(k * uy);
  }
  const std::int64_t times = sign * std::int64_t{stroke.times};
  for (int y = rows.first; y < rows.end; ++y) {
    const double py = y + 0.5 - double{stroke.y};
    const double middle = py * slope;
    // Truncation rounds down, and may include one untouched pixel.
    const auto left = static_cast<int>(between(larger(low, middle - strip) - first_center, 0.0, most));
    const auto end = static_cast<int>(between(smaller(high, middle + strip) - first_center + 1.0, 0.0, most));
    std::int64_t* sum = sums(y);
    for (int x = left; x < end; x += kPixels) {
      const double px = x + first_center;
      const double at = px * ux + py * uy;
      const auto before = static_cast<float>(-at);
      const auto beyond = static_cast<float>(at - size);
      const auto aside = static_cast<float>(px * uy - py * ux);
      std::array<std::int32_t, kPixels> steps{};
      for (std::size_t k = 0; k < kPixels; ++k) {
        const float earlier = before - along[k];
        const float later = beyond + along[k];
        const float either = earlier > later ? earlier : later;
        const float past = either > 0.0F ? either : 0.0F;
        const float off = aside + across[k];
        const float covered = reach - std::sqrt(past * past + off * off);
        const float above = covered > 0.0F ? covered : 0.0F;
        steps[k] = static_cast<std::int32_t>((above < 1.0F ? above : 1.0F) * kSteps + kHalfStep);
      }
      const int count = std::min(kPixels, end - x);
      for (int k = 0; k < count; ++k)
        sum[x + k] += times * factor(static_cast<std::size_t>(steps[static_cast<std::size_t>(k)]));
    }
  }
  mark(rows);
}

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mes::render {
namespace {

// Far inside the range of doubles, so that products of centre, scale and view size stay finite.
constexpr double kMaxCenter = 1e300;
constexpr double kMinUnitsPerPixel = 1e-290;
constexpr double kMaxUnitsPerPixel = 1e290;
constexpr double kMaxScreen = 1e9;
// One pixel of the deepest zoom, relative to the centre: far below the spacing of doubles there.
constexpr double kDeepest = 0x1p-60;
constexpr int kMaxViewport = 1 << 20;

/// The rounded sum and its rounding error (Knuth's two-sum).
struct Sum {
  double value;
  double error;
};
Sum two_sum(double a, double b) {
  const double value = a + b;
  const double part = value - a;
  return {value, (a - (value - part)) + (b - part)};
}

Vec2 clamped_screen(Vec2 p) {
  return {std::clamp(p.x, -kMaxScreen, kMaxScreen), std::clamp(p.y, -kMaxScreen, kMaxScreen)};
}

double finite(double value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(value, -kLargest, kLargest);
}

}  // namespace

void Camera::set_viewport(int width, int height) {
  width_ = std::clamp(width, 1, kMaxViewport);
  height_ = std::clamp(height, 1, kMaxViewport);
}

void Camera::look_at(Vec2 center, double units_per_pixel) {
  if (is_finite(center)) {
    center_ = center;
    center_low_ = {};
  }
  if (std::isfinite(units_per_pixel) && units_per_pixel > 0.0) units_per_pixel_ = units_per_pixel;
  clamp();
}

void Camera::clamp() {
  center_ = {std::clamp(center_.x, -kMaxCenter, kMaxCenter), std::clamp(center_.y, -kMaxCenter, kMaxCenter)};
  units_per_pixel_ = std::clamp(units_per_pixel_, kMinUnitsPerPixel, kMaxUnitsPerPixel);
}

void Camera::move_center(Vec2 delta) {
  const Sum x = two_sum(center_.x, delta.x);
  const Sum y = two_sum(center_.y, delta.y);
  // Renormalised, so that the low part stays below half a unit in the last place of the high one.
  const Sum xn = two_sum(x.value, x.error + center_low_.x);
  const Sum yn = two_sum(y.value, y.error + center_low_.y);
  center_ = {xn.value, yn.value};
  center_low_ = {xn.error, yn.error};
  clamp();
}

Vec2 Camera::to_screen(Vec2 world) const {
  const Vec2 from_center = (world - center_) - center_low_;
  return {finite(0.5 * width_ + from_center.x / units_per_pixel_),
          finite(0.5 * height_ - from_center.y / units_per_pixel_)};
}

Vec2 Camera::to_world(Vec2 screen) const {
  if (!is_finite(screen)) return center_;
  const Vec2 p = clamped_screen(screen);
  const Vec2 from_center{(p.x - 0.5 * width_) * units_per_pixel_, (0.5 * height_ - p.y) * units_per_pixel_};
  return {center_.x + (center_low_.x + from_center.x), center_.y + (center_low_.y + from_center.y)};
}

Box2 Camera::visible() const {
  Box2 box;
  box.add(to_world({0.0, 0.0}));
  box.add(to_world({static_cast<double>(width_), static_cast<double>(height_)}));
  return box;
}

void Camera::zoom_at(Vec2 screen, double factor) {
  if (!is_finite(screen) || !std::isfinite(factor) || factor <= 0.0) return;
  const Vec2 p = clamped_screen(screen);
  const double reach = std::max(std::abs(center_.x), std::abs(center_.y));
  const double deepest = std::min(units_per_pixel_, std::max(kMinUnitsPerPixel, reach * kDeepest));
  const double zoomed = std::clamp(units_per_pixel_ / factor, deepest, kMaxUnitsPerPixel);
  // The point under the cursor is centre + offset * scale before and after, so the centre moves by the difference.
  const double change = units_per_pixel_ - zoomed;
  units_per_pixel_ = zoomed;
  move_center({(p.x - 0.5 * width_) * change, (0.5 * height_ - p.y) * change});
}

void Camera::pan(Vec2 delta) {
  if (!is_finite(delta)) return;
  const Vec2 d = clamped_screen(delta);
  move_center({-d.x * units_per_pixel_, d.y * units_per_pixel_});
}

void Camera::fit(const Box2& box, double margin_px) {
  Box2 shown = box;
  if (shown.is_empty() || !is_finite(shown.low) || !is_finite(shown.high)) shown = {{0.0, 0.0}, {1.0, 1.0}};
  const double margin = std::isfinite(margin_px) ? std::max(margin_px, 0.0) : 0.0;
  // Margins leave at least a quarter of the view to the drawing.
  const double room_x = std::max(width_ - 2.0 * margin, 0.25 * width_);
  const double room_y = std::max(height_ - 2.0 * margin, 0.25 * height_);
  // Halves: the extent of a box of huge numbers need not be representable.
  const double half_x = 0.5 * shown.high.x - 0.5 * shown.low.x;
  const double half_y = 0.5 * shown.high.y - 0.5 * shown.low.y;
  double scale = std::max(half_x / room_x, half_y / room_y) * 2.0;
  if (!(scale > 0.0)) {
    const double size = std::max(std::abs(shown.low.x), std::abs(shown.low.y));
    scale = (size > 0.0 ? size : 1.0) / std::min(room_x, room_y);
  }
  look_at(shown.center(), scale);
}

Camera Camera::part(int left, int top, int width, int height) const {
  Camera out = *this;
  out.set_viewport(width, height);
  // In half pixels, which are exact.
  const double right_by = left + 0.5 * width - 0.5 * width_;
  const double down_by = top + 0.5 * height - 0.5 * height_;
  out.move_center({right_by * units_per_pixel_, -down_by * units_per_pixel_});
  return out;
}

}  // namespace mes::render

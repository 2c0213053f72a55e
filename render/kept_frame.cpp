// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kept_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace mes::render {
namespace {

/// Pixels of a side of a drawing, and where its ends are shown.
struct Stretch {
  int from = 0;
  int from_end = 0;
  int to = 0;
  int to_end = 0;
};

// A pixel x is shown at scale (x - size / 2) + shift + size / 2. Only pixels in view are shown, so that the numbers are
// small; whole pixels, so that neither end jumps while the view moves.
std::optional<Stretch> stretch_of(int size, double scale, double shift) {
  const double half = 0.5 * size;
  const auto pixel_at = [&](double place) { return (place - half - shift) / scale + half; };
  const double low = std::max(std::floor(pixel_at(0.0)), 0.0);
  const double high = std::min(std::ceil(pixel_at(size)), static_cast<double>(size));
  if (!(low < high)) return std::nullopt;
  const auto place_of = [&](double pixel) {
    return static_cast<int>(std::lround(scale * (pixel - half) + shift + half));
  };
  Stretch out{static_cast<int>(low), static_cast<int>(high), place_of(low), place_of(high)};
  if (out.to == out.to_end) return std::nullopt;
  return out;
}

}  // namespace

KeptFrame::~KeptFrame() {
  for (const Frame& frame : {kept_, begun_})
    if (frame.id != FramebufferId{}) device_.destroy_framebuffer(frame.id);
}

FramebufferId KeptFrame::begin(int width, int height) {
  if (!begun_.is_of(width, height)) {
    if (begun_.id != FramebufferId{}) device_.destroy_framebuffer(begun_.id);
    begun_ = {};
    begun_ = {device_.create_framebuffer({.width = width, .height = height}), width, height};
  }
  return begun_.id;
}

void KeptFrame::keep() {
  std::swap(kept_, begun_);
}

void KeptFrame::copy(const Frame& frame, FramebufferId target) const {
  const PixelRect all{0, 0, frame.width, frame.height};
  device_.copy(frame.id, all, target, all, all);
}

void KeptFrame::show_moved(const PixelRect& area, const Camera& was, const Camera& now,
                           const PremultipliedColor& color, FramebufferId target) const {
  constexpr double kMostScale = 1024.0;  // beyond it, a pixel fills the view, or the drawing is a pixel
  device_.clear(target, area, color);
  const double scale = was.units_per_pixel() / now.units_per_pixel();
  if (!(scale > 1.0 / kMostScale && scale < kMostScale)) return;
  const Vec2 shift =
      (1.0 / now.units_per_pixel()) * ((was.center() - now.center()) + (was.center_low() - now.center_low()));
  const auto across = stretch_of(area.width, scale, shift.x);
  const auto up = stretch_of(area.height, scale, shift.y);
  if (!across || !up) return;
  device_.copy(
      kept_.id,
      {area.left + across->from, area.bottom + up->from, across->from_end - across->from, up->from_end - up->from},
      target, {area.left + across->to, area.bottom + up->to, across->to_end - across->to, up->to_end - up->to}, area);
}

}  // namespace mes::render

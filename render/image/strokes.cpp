// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/strokes.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/geometry/box2.h"
#include "render/image/internal/blend.h"

namespace mes::render {
namespace {

/// The rasterizer's numbers have 24 bits before the point; far fewer are needed.
constexpr double kFarthest = 1e6;

bool is_near(double x) {
  return std::abs(x) <= kFarthest;
}
bool is_near(Vec2 p) {
  return is_near(p.x) && is_near(p.y);
}

/// Paints the pixels of the box that `paint` covers.
template <class Paint>
void paint_cover(Image& image, const Box2& box, Rgb color, Paint paint) {
  const int left = std::max(0, static_cast<int>(std::floor(box.low.x)) - 1);
  const int top = std::max(0, static_cast<int>(std::floor(box.low.y)) - 1);
  const int right = std::min(image.width, static_cast<int>(std::ceil(box.high.x)) + 1);
  const int bottom = std::min(image.height, static_cast<int>(std::ceil(box.high.y)) + 1);
  if (left >= right || top >= bottom) return;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_A8, right - left, bottom - top), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
  cairo_translate(cairo.get(), -left, -top);
  cairo_set_line_cap(cairo.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
  paint(cairo.get());
  cairo_surface_flush(surface.get());
  if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) return;
  const unsigned char* const cover = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = top; y < bottom; ++y) {
    const unsigned char* const row = cover + static_cast<std::size_t>(y - top) * stride;
    for (int x = left; x < right; ++x)
      if (row[x - left] != 0) blend(image, x, y, color, row[x - left] / 255.0);
  }
}

Box2 box_around(std::span<const Vec2> points, double margin) {
  Box2 out;
  for (const Vec2 p : points) {
    out.add(p - Vec2{margin, margin});
    out.add(p + Vec2{margin, margin});
  }
  return out;
}

void add_path(cairo_t* cairo, std::span<const Vec2> points) {
  for (const Vec2 p : points) cairo_line_to(cairo, p.x, p.y);
}

}  // namespace

void stroke_path(Image& image, std::span<const Vec2> points, double width, Rgb color) {
  if (points.empty() || !std::ranges::all_of(points, [](Vec2 p) { return is_near(p); })) return;
  paint_cover(image, box_around(points, 0.5 * width), color, [&](cairo_t* cairo) {
    cairo_set_line_width(cairo, width);
    add_path(cairo, points);
    cairo_stroke(cairo);
  });
}

void stroke_arc(Image& image, Vec2 center, double radius, double from, double sweep, double width, Rgb color) {
  if (!is_near(center) || !is_near(radius) || !std::isfinite(from) || !std::isfinite(sweep)) return;
  const Vec2 points[] = {center};
  paint_cover(image, box_around(points, radius + 0.5 * width), color, [&](cairo_t* cairo) {
    cairo_set_line_width(cairo, width);
    if (sweep >= 0.0)
      cairo_arc(cairo, center.x, center.y, radius, from, from + sweep);
    else
      cairo_arc_negative(cairo, center.x, center.y, radius, from, from + sweep);
    cairo_stroke(cairo);
  });
}

void fill_polygon(Image& image, std::span<const Vec2> corners, Rgb color) {
  if (corners.empty() || !std::ranges::all_of(corners, [](Vec2 p) { return is_near(p); })) return;
  paint_cover(image, box_around(corners, 0.0), color, [&](cairo_t* cairo) {
    add_path(cairo, corners);
    cairo_close_path(cairo);
    cairo_fill(cairo);
  });
}

}  // namespace mes::render

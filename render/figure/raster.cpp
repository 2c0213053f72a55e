// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/raster.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "core/base/geometry/box2.h"
#include "render/figure/figure_of.h"
#include "render/figure/internal/cairo_painter.h"

namespace mes::figure {
namespace {

std::unexpected<Error> no_memory(int width, int height) {
  return std::unexpected(Error{ErrorCode::out_of_memory,
                               fmt::format("memory is not enough for a picture of {}x{} pixels", width, height)});
}

/// Divides by alpha, because cairo's pixels are premultiplied.
render::Image unpremultiplied(cairo_surface_t* surface) {
  render::Image out{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  out.rgba.resize(4 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  const unsigned char* const data = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      std::uint32_t value = 0;
      std::memcpy(&value, data + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), 4);
      const std::uint32_t alpha = value >> 24U;
      const auto channel = [&](unsigned shift) {
        return alpha == 0
                   ? std::uint8_t{0}
                   : static_cast<std::uint8_t>(std::min(255U, ((value >> shift & 255U) * 255U + alpha / 2U) / alpha));
      };
      std::uint8_t* const to = &out.rgba[out.offset(x, y)];
      to[0] = channel(16);
      to[1] = channel(8);
      to[2] = channel(0);
      to[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return out;
}

/// The output of `paint` for this part of the page, in points.
template <class Paint>
Expected<render::Image> painted(const Figure& figure, const Box2& part, double pixels_per_point, Paint&& paint) {
  const double sides[] = {part.width() * pixels_per_point, part.height() * pixels_per_point};
  for (const double side : sides)
    if (!(side < kMostPixelsOfSide))
      return std::unexpected(
          Error{ErrorCode::usage, fmt::format("a picture of {:.0f}x{:.0f} pixels is too large; a side has at most {}",
                                              sides[0], sides[1], kMostPixelsOfSide)});
  const auto whole = [](double side) { return std::max(1, static_cast<int>(std::lround(side))); };
  const int width = whole(sides[0]);
  const int height = whole(sides[1]);
  try {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(cairo.get(), width / part.width(), height / part.height());
    cairo_translate(cairo.get(), -part.low.x, -part.low.y);
    CairoPainter painter(cairo.get(), figure);
    std::forward<Paint>(paint)(painter);
    if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) return no_memory(width, height);
    cairo_surface_flush(surface.get());
    return unpremultiplied(surface.get());
  } catch (const std::bad_alloc&) {
    return no_memory(width, height);
  }
}

/// The part of the page that the layer covers, extended to whole pixels.
Box2 part_covered(const Figure& figure, const FigureLayer& layer, double pixels_per_point) {
  const Box2 ink = ink_below_texts(layer);
  if (ink.is_empty() || ink.low.x > figure.width || ink.low.y > figure.height || ink.high.x < 0.0 || ink.high.y < 0.0)
    return {};
  const auto below = [&](double x) { return std::floor(x * pixels_per_point) / pixels_per_point; };
  const auto above = [&](double x) { return std::ceil(x * pixels_per_point) / pixels_per_point; };
  const PagePart seen = layer.clip.value_or(PagePart{{}, figure.width, figure.height});
  const Vec2 low{std::max(seen.corner.x, below(ink.low.x)), std::max(seen.corner.y, below(ink.low.y))};
  const Vec2 high{std::min(seen.corner.x + seen.width, above(ink.high.x)),
                  std::min(seen.corner.y + seen.height, above(ink.high.y))};
  if (low.x > high.x || low.y > high.y) return {};
  return {low, high};
}

}  // namespace

Expected<render::Image> picture_of(const Figure& figure, double pixels_per_point) {
  Box2 page;
  page.add(Vec2{});
  page.add(Vec2{figure.width, figure.height});
  return painted(figure, page, pixels_per_point, [](CairoPainter& painter) { painter.paint(); });
}

Expected<void> rasterize_layers(Figure& figure, std::span<const std::string> layers, double dots_per_inch) {
  const double pixels_per_point = dots_per_inch / kPointsPerInch;
  std::vector<std::pair<FigureLayer*, PlacedImage>> pictures;
  for (FigureLayer& layer : figure.layers) {
    if (std::ranges::find(layers, layer.id) == layers.end() || shape_count(layer) == 0) continue;
    const Box2 part = part_covered(figure, layer, pixels_per_point);
    if (part.is_empty() || !(part.width() > 0.0) || !(part.height() > 0.0)) continue;
    auto picture =
        painted(figure, part, pixels_per_point, [&layer](CairoPainter& painter) { painter.paint_shapes(layer); });
    if (!picture) return std::unexpected(picture.error());
    pictures.push_back({&layer, {std::move(*picture), part.low, part.width(), part.height(), 1.0}});
  }
  for (auto& [layer, picture] : pictures) {
    layer->image = std::move(picture);
    layer->groups.clear();
  }
  return {};
}

}  // namespace mes::figure

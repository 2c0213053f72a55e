// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/cairo_painter.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "core/base/geometry/turn.h"
#include "render/figure/internal/cairo_fonts.h"
#include "render/figure/internal/chains.h"

namespace mes::figure {
namespace {}  // namespace

CairoPainter::CairoPainter(cairo_t* cairo, const Figure& figure) : cairo_(cairo), figure_(figure) {
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_rectangle(cairo_, 0.0, 0.0, figure_.width, figure_.height);
  cairo_clip(cairo_);
  // Letters keep the positions of the layout, not whole pixels.
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo_, options.get());
}

void CairoPainter::paint() {
  if (figure_.background) {
    color(*figure_.background, 1.0);
    cairo_paint(cairo_);
  }
  for (const FigureLayer& layer : figure_.layers) paint(layer);
  legend();
}

void CairoPainter::color(Rgb color, double opacity) {
  cairo_set_source_rgba(cairo_, color.r / 255.0, color.g / 255.0, color.b / 255.0, opacity);
}

void CairoPainter::paint(const FigureLayer& layer) {
  cairo_save(cairo_);
  clip(layer);
  paint_layer(layer);
  for (const Text& text : layer.texts) paint(text);
  cairo_restore(cairo_);
}

void CairoPainter::clip(const FigureLayer& layer) {
  if (!layer.clip) return;
  cairo_rectangle(cairo_, layer.clip->corner.x, layer.clip->corner.y, layer.clip->width, layer.clip->height);
  cairo_clip(cairo_);
}

void CairoPainter::paint_shapes(const FigureLayer& layer) {
  cairo_save(cairo_);
  clip(layer);
  paint_layer(layer);
  cairo_restore(cairo_);
}

void CairoPainter::paint_layer(const FigureLayer& layer) {
  cairo_set_line_width(cairo_, layer.line_width);
  if (layer.image) image(*layer.image);
  for (const Group& group : layer.groups) {
    if (group.opacity < 1.0) cairo_push_group(cairo_);
    for (const Run& run : group.runs) paint(run);
    if (group.opacity >= 1.0) continue;
    cairo_pop_group_to_source(cairo_);
    cairo_paint_with_alpha(cairo_, group.opacity);
  }
}

void CairoPainter::image(const PlacedImage& placed) {
  const render::Image& image = placed.image;
  cairo_surface_t* const pixels = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height);
  if (cairo_surface_status(pixels) == CAIRO_STATUS_SUCCESS) {
    unsigned char* const data = cairo_image_surface_get_data(pixels);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(pixels));
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* const from = &image.rgba[image.offset(x, y)];
        const unsigned alpha = from[3];
        const auto premultiplied = [alpha](unsigned channel) { return (channel * alpha + 127U) / 255U; };
        const std::uint32_t value =
            alpha << 24U | premultiplied(from[0]) << 16U | premultiplied(from[1]) << 8U | premultiplied(from[2]);
        std::memcpy(data + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), &value, 4);
      }
    }
    cairo_surface_mark_dirty(pixels);
    cairo_save(cairo_);
    cairo_translate(cairo_, placed.corner.x, placed.corner.y);
    cairo_scale(cairo_, placed.width / image.width, placed.height / image.height);
    cairo_set_source_surface(cairo_, pixels, 0.0, 0.0);
    cairo_paint_with_alpha(cairo_, placed.opacity);
    cairo_restore(cairo_);
  }
  cairo_surface_destroy(pixels);
}

void CairoPainter::paint(const Run& run) {
  color(run.color, run.opacity);
  const bool is_solid = run.dashes == Dashes{};
  cairo_set_line_cap(cairo_, is_solid ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  const double dashes[] = {run.dashes.on, run.dashes.off};
  cairo_set_dash(cairo_, dashes, is_solid ? 0 : 2, run.dashes.offset);
  const bool is_one_path = run.opacity >= 1.0;
  const std::span<const Shape> shapes(run.shapes);
  bool is_open = false;
  const auto end = [&] {
    if (run.is_filled)
      cairo_fill(cairo_);
    else
      cairo_stroke(cairo_);
  };
  for (std::size_t i = 0; i < shapes.size();) {
    const bool is_disk = shapes[i].kind == ShapeKind::disk;
    i += path(shapes, i, is_one_path);
    is_open = is_one_path && !is_disk;
    if (!is_open) end();
  }
  if (is_open) end();
}

void CairoPainter::curve(const Bezier& bezier) {
  cairo_curve_to(cairo_, bezier.first_handle.x, bezier.first_handle.y, bezier.second_handle.x, bezier.second_handle.y,
                 bezier.end.x, bezier.end.y);
}

std::size_t CairoPainter::path(std::span<const Shape> shapes, std::size_t i, bool with_chains) {
  const Shape& shape = shapes[i];
  const auto line = [&](Vec2 p) { cairo_line_to(cairo_, p.x, p.y); };
  if (shape.kind == ShapeKind::disk || shape.kind == ShapeKind::circle) {
    cairo_new_sub_path(cairo_);
    cairo_arc_negative(cairo_, shape.p[0].x, shape.p[0].y, shape.radius, kTurn, 0.0);
    cairo_close_path(cairo_);
    return 1;
  }
  cairo_move_to(cairo_, shape.p[0].x, shape.p[0].y);
  switch (shape.kind) {
    case ShapeKind::disk:
    case ShapeKind::circle: return 1;
    case ShapeKind::parabola:
    case ShapeKind::segment: {
      const std::size_t count = with_chains ? chain_length(shapes, i) : 1;
      const std::span<const Shape> chain = shapes.subspan(i, count);
      for (const Shape& side : chain) {
        if (side.kind == ShapeKind::segment)
          line(side.p[1]);
        else
          curve(parabola_curve(side));
      }
      if (is_loop(chain)) cairo_close_path(cairo_);
      return count;
    }
    case ShapeKind::triangle:
      line(shape.p[1]);
      line(shape.p[2]);
      cairo_close_path(cairo_);
      return 1;
    case ShapeKind::arc:
      for (const Bezier& bezier : arc_curves(shape, figure_.decimals)) curve(bezier);
      return 1;
    case ShapeKind::curve:
    case ShapeKind::rim:
      curve({shape.p[1], shape.p[2], shape.p[3]});
      if (shape.kind == ShapeKind::rim) {
        line(shape.p[4]);
        line(shape.p[5]);
        cairo_close_path(cairo_);
      }
      return 1;
  }
  return 1;
}

void CairoPainter::legend() {
  for (const Box& box : figure_.legend.boxes) {
    color(box.color, box.opacity);
    cairo_rectangle(cairo_, box.corner.x, box.corner.y, box.width, box.height);
    cairo_fill(cairo_);
  }
  for (const Run& run : figure_.legend.runs) paint(run);
  for (const Text& text : figure_.legend.texts) paint(text);
}

void CairoPainter::paint(const Text& text) {
  if (text.text.empty()) return;
  cairo_save(cairo_);
  cairo_translate(cairo_, text.start.x, text.start.y);
  color(text.color, text.opacity);
  if (!show_glyphs(text)) show_in_named_font(text);
  cairo_restore(cairo_);
}

void CairoPainter::keep_to(double width, double measured) {
  // Tolerance: the layout was measured at another size, in single precision.
  constexpr double kRounding = 1e-4;
  if (width > 0.0 && measured > (1.0 + kRounding) * width) cairo_scale(cairo_, width / measured, 1.0);
}

bool CairoPainter::show_glyphs(const Text& text) {
  if (!figure_.fonts) return false;
  const render::Font& font = figure_.fonts->of(text.is_bold, text.is_italic);
  cairo_font_face_t* const face = cairo_face_of(font);
  if (face == nullptr) return false;
  const double unit = text.size / font.units_per_size();
  std::vector<cairo_glyph_t> glyphs;
  double width = 0.0;
  for (const render::Glyph& glyph : font.glyphs(text.text)) {
    glyphs.push_back({static_cast<unsigned long>(glyph.index), unit * glyph.x, 0.0});
    width = unit * (glyph.x + glyph.advance);
  }
  cairo_set_font_face(cairo_, face);
  cairo_set_font_size(cairo_, unit * font.units_per_em());
  keep_to(text.width, width);
  cairo_show_glyphs(cairo_, glyphs.data(), static_cast<int>(glyphs.size()));
  return true;
}

void CairoPainter::show_in_named_font(const Text& text) {
  cairo_select_font_face(cairo_, "Helvetica", text.is_italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                         text.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, kEmOfSize * text.size);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, text.text.c_str(), &extents);
  keep_to(text.width, extents.x_advance);
  cairo_move_to(cairo_, 0.0, 0.0);
  cairo_show_text(cairo_, text.text.c_str());
}

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
// Paints a figure through cairo, on any of its surfaces.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <span>

#include "render/figure/figure.h"
#include "render/figure/internal/bezier_arcs.h"

namespace mes::figure {

/// The status of `cairo` tells whether painting succeeded. Threads: one at a time.
class CairoPainter {
 public:
  /// Lengths are in points: the matrix of `cairo` scales them to the units of its surface.
  CairoPainter(cairo_t* cairo, const Figure& figure);

  /// Paints the whole figure, cut at the edge of its page.
  void paint();
  /// Paints the image and shapes of one layer of it, without texts.
  void paint_shapes(const FigureLayer& layer);

 private:
  void color(Rgb color, double opacity);
  void image(const PlacedImage& placed);
  void paint(const FigureLayer& layer);
  void clip(const FigureLayer& layer);
  void paint_layer(const FigureLayer& layer);
  void paint(const Run& run);
  void paint(const Text& text);
  /// Shows text in a font of the figure; false if it has no font, or FreeType cannot read it.
  bool show_glyphs(const Text& text);
  /// Shows text in Helvetica, or the system's substitute.
  void show_in_named_font(const Text& text);
  /// Narrows the following text if it is wider than measured by its layout.
  void keep_to(double width, double measured);
  void curve(const Bezier& bezier);
  /// Adds the shape at `i`, or the chain that begins there, to the path. Returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains);
  void legend();

  cairo_t* cairo_;
  const Figure& figure_;
};

}  // namespace mes::figure

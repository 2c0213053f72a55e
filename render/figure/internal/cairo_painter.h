// SPDX-License-Identifier: GPL-3.0-or-later
// A figure painted through cairo, on whichever of its surfaces.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <span>

#include "render/figure/figure.h"
#include "render/figure/internal/bezier_arcs.h"

namespace mes::figure {

/// Whether it worked is in the status of `cairo`. Threads: one at a time.
class CairoPainter {
 public:
  /// Lengths are in points: the matrix of `cairo` scales them to what its surface counts in.
  CairoPainter(cairo_t* cairo, const Figure& figure);

  /// The whole figure, cut at the edge of its page.
  void paint();
  /// Image and shapes of one layer of it alone, without its texts.
  void paint_shapes(const FigureLayer& layer);

 private:
  void color(Rgb color, double opacity);
  void image(const PlacedImage& placed);
  void paint(const FigureLayer& layer);
  void clip(const FigureLayer& layer);
  void paint_layer(const FigureLayer& layer);
  void paint(const Run& run);
  void paint(const Text& text);
  /// In a font of the figure; false if it has none, or FreeType does not read it.
  bool show_glyphs(const Text& text);
  /// In Helvetica, or in what the system has instead.
  void show_in_named_font(const Text& text);
  /// Makes what follows narrower if it is wider than its layout measured.
  void keep_to(double width, double measured);
  void curve(const Bezier& bezier);
  /// Adds the shape at `i`, or the chain that begins there, to the path. Returns the number of shapes.
  std::size_t path(std::span<const Shape> shapes, std::size_t i, bool with_chains);
  void legend();

  cairo_t* cairo_;
  const Figure& figure_;
};

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
// Figures in pixels, painted without OpenGL: for a preview, and for layers of a figure that are to be pictures.
#pragma once

#include <span>
#include <string>

#include "core/base/error.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// Sides of pictures are whole pixels, at most this many.
inline constexpr int kMostPixelsOfSide = 32'767;
/// The resolution of layers that a vector format shows as pictures.
inline constexpr double kDotsPerInch = 300.0;

/// The figure at so many pixels a point; what it does not cover is transparent. Its sides are rounded to whole pixels.
/// Error: `usage` for a picture that is too large, `out_of_memory`.
///
/// Cost: O(pixels + area of the shapes), some microseconds a shape. Threads: any.
Expected<render::Image> picture_of(const Figure& figure, double pixels_per_point);

/// Puts a picture of the page in the place of all shapes of these layers, given by their ids; others stay as they are.
/// It is as large as what it shows, at so many dots an inch. Layers that show nothing on the page stay empty. Texts of
/// the layers stay text, above the picture, so that they can still be read sharply, searched and edited.
/// Errors as above; then the figure is as before.
Expected<void> rasterize_layers(Figure& figure, std::span<const std::string> layers, double dots_per_inch);

}  // namespace mes::figure

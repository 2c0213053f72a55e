// SPDX-License-Identifier: GPL-3.0-or-later
// Rasterizes figures without OpenGL: for a preview, and for layers that should be pictures.
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

/// The figure at this resolution; uncovered pixels are transparent. Its sides are rounded to whole pixels. Error:
/// `usage` for a picture that is too large, `out_of_memory`.
///
/// Cost: O(pixels + area of the shapes), some microseconds a shape. Threads: any.
Expected<render::Image> picture_of(const Figure& figure, double pixels_per_point);

/// Replaces all shapes of the layers with these ids by a picture at this resolution; other layers stay. The picture
/// covers only the visible content. Layers without content on the page stay empty. Texts of the layers stay text, above
/// the picture, and so remain sharp, searchable and editable. Errors as above; the figure is then unchanged.
Expected<void> rasterize_layers(Figure& figure, std::span<const std::string> layers, double dots_per_inch);

}  // namespace mes::figure

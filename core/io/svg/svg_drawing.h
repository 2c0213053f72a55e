// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the curves of an SVG drawing. Private to core/io.
//
// Reads everything visible in a viewer: paths and basic shapes with their transforms, groups, `use`, symbols and nested
// viewports, as far as style sheets, visibility, opacity and paint allow, and within their clip paths. Clipped areas
// end at the clip path; strokes become their middle lines, and end there too. The page itself clips nothing.
//
// Hidden or unpainted elements, text and pictures, patterns and markers are left out with a warning; masks are not
// applied, with a warning. Definitions are not drawn by themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/curves/curve.h"
#include "core/io/text/read_job.h"

namespace mes {

struct SvgDrawing {
  CurveSet curves;                    ///< y up, the lower left corner of the drawing at the origin
  std::string unit = "px";            ///< of coordinates: that of width and height of the page, else 1/96 inch
  Vec2 page{};                        ///< its width and height; zero if the drawing has none
  std::vector<std::string> warnings;  ///< one line a kind, with the position of the first
};

/// Whether the root element is that of SVG. Reads only up to it.
bool looks_like_svg(std::string_view bytes);

/// Error: `bad_input` with line and column for text that is not XML, and for too many elements or pieces or too deep
/// nesting, so that a few lines of `use` cannot grow without bounds. Entities other than those of XML are not expanded.
/// Throws `Cancelled`. Threads: uses several of its own for large drawings.
Expected<SvgDrawing> read_svg_drawing(std::string_view bytes, const std::string& name, ReadJob& job);

}  // namespace mes

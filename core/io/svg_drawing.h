// SPDX-License-Identifier: GPL-3.0-or-later
// The curves that an SVG drawing consists of. Private to core/io.
//
// What a viewer shows is read: paths and basic shapes with their transforms, groups, `use`, symbols, nested viewports, as
// far as style sheets, visibility, opacity and paint let them be seen, and within their clip paths. Areas that are cut end at
// the clip path; strokes are their middle lines, and end there. The page itself cuts nothing.
//
// Left out with a warning are what is hidden or has no paint, text and pictures, patterns and markers; masks are not applied,
// with a warning. Definitions are not drawn by themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/curves/curve.h"
#include "core/io/read_job.h"

namespace mes {

struct SvgDrawing {
  CurveSet curves;                    ///< in pixels, y up, the lower left corner of the drawing at the origin
  std::vector<std::string> warnings;  ///< one line a kind, with the place of the first
};

/// Whether the root element is that of SVG. A look at what stands before it.
bool looks_like_svg(std::string_view bytes);

/// Error: `bad_input` with line and column for text that is not XML, and for what has too many elements or pieces or is
/// nested too deeply, so that a few lines of `use` cannot grow without bounds. Entities other than those of XML are not
/// expanded. Throws `Cancelled`. Threads: several of its own, where there is enough for them to do.
Expected<SvgDrawing> read_svg_drawing(std::string_view bytes, const std::string& name, ReadJob& job);

}  // namespace mes

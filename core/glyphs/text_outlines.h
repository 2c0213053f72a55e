// SPDX-License-Identifier: GPL-3.0-or-later
// The outlines of a text in a font, as curves.
//
// Letters stand as the font says: HarfBuzz shapes each line, with kerning and ligatures. Where contours overlap, in a
// letter or between letters, they become one: the boundary of all that they wind around (core/glyphs/internal).
// Everything else keeps the Bézier curves of the font, exactly.
//
// Smallest use:
//     const auto font = find_font("DejaVu Sans");
//     if (!font) return;  // which fonts there are is up to the machine
//     const auto outlines = outlines_of_text({.text = "B", .font = *font});
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/curves/curve.h"
#include "core/glyphs/fonts.h"

namespace mes {

struct TextRequest {
  std::string text{};  ///< UTF-8; lines end at LF
  FontFile font{};
  double size = 100.0;        ///< of an em, in units of the plane
  double line_spacing = 1.0;  ///< from line to line, as a multiple of what the font says
  bool has_kerning = true;
  friend bool operator==(const TextRequest&, const TextRequest&) = default;
};

struct TextOutlines {
  CurveSet curves{};                   ///< closed; the first line stands on y = 0 and begins at x = 0
  std::vector<std::string> remarks{};  ///< one line a kind: what the font has no glyph for
};

inline constexpr std::size_t kLongestText = 10'000;  // bytes

/// Equal requests and font files give equal curves. Cost: some 10 us for each letter, more where contours overlap. Any
/// thread. Error: `usage` for a text that is too long, or a size that is not positive; `bad_input` for a file that is no
/// font, and for a text of which nothing is drawn, with the reason. Throws `Cancelled` if there is a job, which is looked at
/// for each glyph, but not while overlapping contours are united.
Expected<TextOutlines> outlines_of_text(const TextRequest& request, JobControl* job = nullptr);

}  // namespace mes

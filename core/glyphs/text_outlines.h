// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of text in a font, as curves.
//
// The font positions the letters: HarfBuzz shapes each line, with kerning and ligatures. Where contours overlap, in a
// letter or between letters, they are replaced by the boundary of their union (core/glyphs/internal). All other
// contours keep the Bézier curves of the font, exactly.
//
// Smallest use:
//     const auto font = find_font("DejaVu Sans");
//     if (!font) return;  // which fonts there are is up to the machine
//     const auto outlines = outlines_of_text({.text = "B", .font = *font});
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"
#include "core/glyphs/fonts.h"

namespace mes {

struct TextRequest {
  std::string text{};  ///< UTF-8; lines end at LF
  FontFile font{};
  double size = 100.0;        ///< size of an em, in units of the plane
  double line_spacing = 1.0;  ///< distance between lines, as a multiple of the font's own
  bool has_kerning = true;
  friend bool operator==(const TextRequest&, const TextRequest&) = default;
};

struct TextOutlines {
  CurveSet curves{};                   ///< closed; the baseline of the first line is y = 0, and it begins at x = 0
  std::vector<std::string> remarks{};  ///< one line for each kind: characters that the font has no glyph for
};

inline constexpr std::size_t kLongestText = 10'000;  // bytes

/// Equal requests and font files give equal curves. Cost: about 10 us for each letter, more where contours overlap. Any
/// thread. Error: `usage` for a text that is too long, or a size that is not positive; `bad_input` for a file that is
/// not a font, and for a text without visible outlines, with the reason. Throws `Cancelled` if there is a job, which is
/// checked for each glyph, but not while overlapping contours are united.
Expected<TextOutlines> outlines_of_text(const TextRequest& request, JobControl* job = nullptr);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Text of annotations: a small part of LaTeX, laid out by ourselves and passed on to TeX where that typesets.
//
// It understands the following, and shows everything else unchanged:
//   $...$                       mathematics: letters in italics, spaces as operators require
//   x_1  x^2  x_{ij}^{2}        sub- and superscripts, within mathematics
//   \alpha ... \Omega           Greek letters, and the signs of `rich_text_signs`, anywhere
//   \textbf{}  \textit{}  \emph{}  \mathrm{}
//   \\ or a new line            another line
//   \$ \% \& \# \_ \{ \}        the sign itself
//   \value                      the measurement of a dimension
//
// Smallest use:
//     const RichText words = rich_text("radius $r_i$ = \\value", "2.5", 15.0, measure);
//
// Cost: O(length), besides measuring. Threads: any.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/paper/paper_drawing.h"

namespace mes {

/// A piece of text in one look.
struct RichPiece {
  double x = 0.0;      ///< distance from the beginning of the line
  double raise = 0.0;  ///< height of the baseline above that of the line
  double size = 0.0;
  Face face = Face::plain;
  std::string text;  ///< UTF-8
};

/// Lengths are in the unit of `letters`.
struct RichLine {
  double width = 0.0;
  std::vector<RichPiece> pieces{};
  std::string latex{};  ///< the same for TeX: only the elements listed above, all other signs escaped
};

struct RichText {
  std::vector<RichLine> lines{};
  std::string complaint{};  ///< about the first part that is not understood; empty if all is
};

/// `value` replaces `\value`. Bytes that are not UTF-8 are shown as question marks. Text without letters has no
/// lines.
RichText rich_text(std::string_view words, std::string_view value, double letters, const MeasureText& measure);

/// Replaces each byte that is not UTF-8 by a question mark, and control characters other than new lines by spaces.
std::string readable_text(std::string_view text);

/// Adds the letters of a line whose baseline begins at `start`.
void add_pieces(const RichLine& line, Vec2 start, Rgb color, std::vector<PaperDrawing::Line>& to);

/// A command and the sign that it stands for.
struct RichSign {
  std::string_view command;  ///< without the backslash
  std::string_view sign;     ///< UTF-8; the fonts contain it
};
std::span<const RichSign> rich_text_signs();

}  // namespace mes

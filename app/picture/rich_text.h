// SPDX-License-Identifier: GPL-3.0-or-later
// Words of annotations: a small part of LaTeX, laid out by ourselves and handed on to TeX where that typesets.
//
// What it understands, the rest being shown as it stands:
//   $...$                       mathematics: letters in italics, spaces as operators ask for them
//   x_1  x^2  x_{ij}^{2}        sub- and superscripts, within mathematics
//   \alpha ... \Omega           Greek letters, and the signs of `rich_text_signs`, anywhere
//   \textbf{}  \textit{}  \emph{}  \mathrm{}
//   \\ or a new line            another line
//   \$ \% \& \# \_ \{ \}        the sign itself
//   \value                      what a dimension measures
//
// Smallest use:
//     const RichText words = rich_text("radius $r_i$ = \\value", "2.5", 15.0, measure);
//
// Cost: O(length) beside measuring. Threads: any.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/paper_drawing.h"

namespace mes {

/// Letters of one look.
struct RichPiece {
  double x = 0.0;      ///< from the beginning of the line
  double raise = 0.0;  ///< of the baseline above that of the line
  double size = 0.0;
  Face face = Face::plain;
  std::string text;  ///< UTF-8
};

/// Lengths are in the unit of `letters`.
struct RichLine {
  double width = 0.0;
  std::vector<RichPiece> pieces{};
  std::string latex{};  ///< the same for TeX: nothing in it but what is listed above, other signs escaped
};

struct RichText {
  std::vector<RichLine> lines{};
  std::string complaint{};  ///< about the first thing that is not understood; empty: all is
};

/// `value` stands for `\value`. Bytes that are not UTF-8 are shown as question marks. Text without letters has no lines.
RichText rich_text(std::string_view words, std::string_view value, double letters, const MeasureText& measure);

/// With a question mark for each byte that is not UTF-8, and a space for control characters other than new lines.
std::string readable_text(std::string_view text);

/// The letters of a line whose baseline begins at `start`.
void add_pieces(const RichLine& line, Vec2 start, Rgb color, std::vector<PaperDrawing::Line>& to);

/// A command and the sign it stands for.
struct RichSign {
  std::string_view command;  ///< without the backslash
  std::string_view sign;     ///< UTF-8; the fonts have it
};
std::span<const RichSign> rich_text_signs();

}  // namespace mes

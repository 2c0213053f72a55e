// SPDX-License-Identifier: GPL-3.0-or-later
// Captions of lessons: a small part of Markdown, laid out in a column or written as HTML.
//
// It understands the following, and shows everything else unchanged:
//   # Heading, ## ..., ### ...   on a line of its own
//   - item                       a list; following lines that are not empty continue the item
//   an empty line                ends a paragraph or an item; other line ends are spaces
//   **bold**  *italics*          within one block
//   $...$                        mathematics, as in rich_text.h
//   \* \$ \# \- \\ \_            the sign itself
//
// Smallest use:
//     const CaptionText text = caption_text("# Crust\n\nThe **crust** of $P$");
//     const CaptionDrawing drawn = layout_caption(text, {.width = 300.0, .letters = 18.0}, measure);
//
// Cost: O(length), but quadratic for signs of emphasis that are not closed. Threads: any.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/paper/paper_drawing.h"

namespace mes {

/// Text of one look.
struct CaptionSpan {
  std::string text;  ///< UTF-8; for mathematics the source between the dollars
  bool is_bold = false;
  bool is_italic = false;
  bool is_mathematics = false;
  friend bool operator==(const CaptionSpan&, const CaptionSpan&) = default;
};

struct CaptionBlock {
  enum class Kind : std::uint8_t { heading, paragraph, item };
  Kind kind = Kind::paragraph;
  int level = 1;  ///< level of a heading, from 1 to 3
  std::vector<CaptionSpan> spans{};
  friend bool operator==(const CaptionBlock&, const CaptionBlock&) = default;
};

using CaptionText = std::vector<CaptionBlock>;

/// Bytes that are not UTF-8 become question marks, and control characters spaces. Blocks without text are left out.
CaptionText caption_text(std::string_view markdown);

/// The text of a block on one line.
std::string plain_text(const CaptionBlock& block);

/// The one-line name of a caption: its first heading, or else the beginning of its first block.
std::string name_of(const CaptionText& text);

/// Lengths are in logical pixels.
struct CaptionLook {
  double width = 300.0;   ///< width of the column
  double letters = 18.0;  ///< letter size of paragraphs
  Rgb ink{0x1f, 0x23, 0x28};
};

struct CaptionDrawing {
  PaperDrawing drawing;     ///< begins at the upper left corner of the column; as wide as its longest line
  std::string complaint{};  ///< about the first unknown part of mathematics; empty if all is understood
};

/// Breaks words wider than the column; only mathematics may be wider than it.
CaptionDrawing layout_caption(const CaptionText& text, const CaptionLook& look, const MeasureText& measure);

struct FittedCaption {
  PaperDrawing drawing;
  std::string complaint{};  ///< the same as in `CaptionDrawing`
  bool is_whole = true;     ///< false: it is cut off, because it is too long even in the smallest letters
};

/// Uses the largest letters in which the caption and those `beside` it, such as all captions of a lesson, fit into the
/// room, down to a hardly readable size.
FittedCaption fit_caption(const CaptionText& text, CaptionLook look, double height, const MeasureText& measure,
                          std::span<const CaptionText> beside = {});

/// Uses the elements h2 to h4, p, ul and li, and escapes everything that was not understood.
std::string html_of(const CaptionText& text);

/// Replaces the special characters of HTML and XML by entities, so that the text can stand in attributes too.
std::string escaped_html(std::string_view text);

}  // namespace mes

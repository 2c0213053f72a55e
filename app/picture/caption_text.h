// SPDX-License-Identifier: GPL-3.0-or-later
// Captions of lessons: a small part of Markdown, laid out in a column or written as HTML.
//
// What it understands, the rest being shown as it stands:
//   # Heading, ## ..., ### ...   on a line of its own
//   - item                       a list; lines after it that are not empty go on with the item
//   an empty line                ends a paragraph or an item; other ends of lines are spaces
//   **bold**  *italics*          within one block
//   $...$                        mathematics, as in rich_text.h
//   \* \$ \# \- \\ \_            the sign itself
//
// Smallest use:
//     const CaptionText text = caption_text("# Crust\n\nThe **crust** of $P$");
//     const CaptionDrawing drawn = layout_caption(text, {.width = 300.0, .letters = 18.0}, measure);
//
// Cost: O(length of it), and the square of that for signs of emphasis that are not closed. Threads: any.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/paper_drawing.h"

namespace mes {

/// Letters of one look.
struct CaptionSpan {
  std::string text;  ///< UTF-8; of mathematics what stands between the dollars
  bool is_bold = false;
  bool is_italic = false;
  bool is_mathematics = false;
  friend bool operator==(const CaptionSpan&, const CaptionSpan&) = default;
};

struct CaptionBlock {
  enum class Kind : std::uint8_t { heading, paragraph, item };
  Kind kind = Kind::paragraph;
  int level = 1;  ///< of a heading, from 1 to 3
  std::vector<CaptionSpan> spans{};
  friend bool operator==(const CaptionBlock&, const CaptionBlock&) = default;
};

using CaptionText = std::vector<CaptionBlock>;

/// Bytes that are not UTF-8 become question marks, control characters spaces. Blocks without letters are left out.
CaptionText caption_text(std::string_view markdown);

/// The letters of a block on one line.
std::string plain_text(const CaptionBlock& block);

/// What a caption is called where there is one line for it: its first heading, or else how its first block begins.
std::string name_of(const CaptionText& text);

/// Lengths are in logical pixels.
struct CaptionLook {
  double width = 300.0;   ///< of the column
  double letters = 18.0;  ///< size of those of paragraphs
  Rgb ink{0x1f, 0x23, 0x28};
};

struct CaptionDrawing {
  PaperDrawing drawing;     ///< from the upper left corner of the column; as wide as its longest line
  std::string complaint{};  ///< about the first thing in mathematics that is not understood; empty: all is
};

/// Words that are wider than the column are broken; only mathematics may be wider than it.
CaptionDrawing layout_caption(const CaptionText& text, const CaptionLook& look, const MeasureText& measure);

struct FittedCaption {
  PaperDrawing drawing;
  std::string complaint{};  ///< as that of `CaptionDrawing`
  bool is_whole = true;     ///< false: it is longer than its room even so, and ends where that ends
};

/// In letters as large as fit into the room, down to a size that can hardly be read.
FittedCaption fit_caption(const CaptionText& text, CaptionLook look, double height, const MeasureText& measure);

/// Elements h2 to h4, p, ul and li, with nothing in them but what was understood: all else is escaped.
std::string html_of(const CaptionText& text);

/// With the signs that mean something in HTML and XML as entities, in attributes too.
std::string escaped_html(std::string_view text);

}  // namespace mes

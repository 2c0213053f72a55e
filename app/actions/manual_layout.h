// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of the manual's text on a page of a given width and any length.
//
// Guarantees: no piece of text begins or ends outside the page, unless a single letter is wider than the room for it;
// blocks lie one below the other; the cells of a table are aligned, and so are words below each other in code. Where the
// columns of a table are too narrow for its words, the cells of a row lie below each other, each with the title of its
// column.
//
// Smallest use:
//     const ManualLayout page = lay_out(manual, {.width = 600, .measure = ..., .line = ...});
//     const auto [first, last] = page.blocks_between(scroll, scroll + height);
//     for (std::size_t i = page.blocks[first].first_piece; i < page.blocks[last].first_piece; ++i) draw(page.pieces[i]);
//
// Cost: `lay_out` measures every word a few times; the blocks in view are found in logarithmic time. Threads: none.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/actions/manual_text.h"

namespace mes {

struct ManualMetrics {
  double width = 0.0;
  double unit = 1.0;  ///< one logical pixel
  std::function<double(std::string_view text, ManualStyle style)> measure{};
  std::function<double(ManualStyle style)> line{};  ///< height of a line
};

/// A stretch of text on one line, in one style.
struct ManualPiece {
  std::size_t block = 0;  ///< the source of its text
  std::size_t cell = 0;
  std::size_t begin = 0;  ///< bytes of the text of the cell
  std::size_t end = 0;
  ManualStyle style = ManualStyle::plain;
  double x = 0.0;  ///< upper left corner
  double y = 0.0;
  double width = 0.0;
};

struct ManualLayout {
  struct Block {
    double top = 0.0;
    double bottom = 0.0;
    std::size_t first_piece = 0;
  };
  std::vector<Block> blocks;  ///< one more than the text has; the last one is empty, at the end
  std::vector<ManualPiece> pieces;
  double height = 0.0;

  /// The blocks [first, last) that reach between the two heights.
  std::pair<std::size_t, std::size_t> blocks_between(double top, double bottom) const;
  /// The piece in which this stretch begins; its block must have text.
  const ManualPiece& piece_of(const ManualFind& find) const;
};

ManualLayout lay_out(const ManualText& manual, const ManualMetrics& metrics);

}  // namespace mes

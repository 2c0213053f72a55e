// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/manual_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/assert.h"

namespace mes {
namespace {

// Logical pixels.
constexpr double kAboveTitle = 26.0;
constexpr double kAboveSubtitle = 16.0;
constexpr double kBelowHeading = 8.0;
constexpr double kBelowParagraph = 10.0;
constexpr double kBetweenItems = 4.0;
constexpr double kItemIndent = 18.0;
constexpr double kCodeIndent = 10.0;
constexpr double kCodeMargin = 8.0;
constexpr double kCellPadding = 4.0;
constexpr double kBetweenColumns = 18.0;
// A letter of code takes this part of the height of a line: about the mean width of a letter, so that words rarely reach
// into the column to their right.
constexpr double kCodeColumn = 0.38;
// The last column of code, and the text beside a title, begin left of this part of the width, so that there is room.
constexpr double kLargestStart = 0.42;

std::size_t end_of_letter(std::string_view text, std::size_t at) {
  ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
  return at;
}

/// Calls `visit(begin, end, style)` for the parts of [begin, end) that have one style each.
template <class Visit>
void for_each_style(const ManualCell& cell, ManualStyle usual, std::size_t begin, std::size_t end, Visit visit) {
  for (const ManualSpan& span : cell.spans) {
    if (span.end <= begin) continue;
    if (span.begin >= end) break;
    if (begin < span.begin) visit(begin, span.begin, usual);
    begin = std::max(begin, span.begin);
    const std::size_t to = std::min(end, span.end);
    visit(begin, to, span.style);
    begin = to;
  }
  if (begin < end) visit(begin, end, usual);
}

class LayoutMaker {
 public:
  LayoutMaker(const ManualText& manual, const ManualMetrics& metrics) : manual_(manual), metrics_(metrics) {}

  ManualLayout make() {
    for (block_ = 0; block_ < manual_.blocks.size(); ++block_) {
      const ManualBlock& block = manual_.blocks[block_];
      y_ += above(block);
      out_.blocks.push_back({y_, y_, out_.pieces.size()});
      place(block);
      out_.blocks.back().bottom = y_;
      y_ += below(block);
    }
    out_.blocks.push_back({y_, y_, out_.pieces.size()});
    out_.height = y_;
    return std::move(out_);
  }

 private:
  const ManualBlock* neighbor(std::ptrdiff_t by) const {
    const auto at = static_cast<std::ptrdiff_t>(block_) + by;
    const bool is_there = at >= 0 && at < static_cast<std::ptrdiff_t>(manual_.blocks.size());
    return is_there ? &manual_.blocks[static_cast<std::size_t>(at)] : nullptr;
  }
  bool ends_run(const ManualBlock& block, std::ptrdiff_t by) const {
    const ManualBlock* const other = neighbor(by);
    return other == nullptr || other->kind != block.kind;
  }

  double above(const ManualBlock& block) const {
    double out = 0.0;
    if (block.kind == ManualBlockKind::heading && block_ > 0) out = block.level <= 2 ? kAboveTitle : kAboveSubtitle;
    if (block.kind == ManualBlockKind::code && ends_run(block, -1)) out = kCodeMargin;
    return out * metrics_.unit;
  }

  double below(const ManualBlock& block) const {
    double out = 0.0;
    switch (block.kind) {
      case ManualBlockKind::heading: out = kBelowHeading; break;
      case ManualBlockKind::paragraph: out = kBelowParagraph; break;
      case ManualBlockKind::item: out = ends_run(block, 1) ? kBelowParagraph : kBetweenItems; break;
      case ManualBlockKind::code: out = ends_run(block, 1) ? kCodeMargin + kBelowParagraph : 0.0; break;
      case ManualBlockKind::head: break;
      case ManualBlockKind::row: out = ends_run(block, 1) ? kBelowParagraph : 0.0; break;
    }
    return out * metrics_.unit;
  }

  void place(const ManualBlock& block) {
    switch (block.kind) {
      case ManualBlockKind::heading:
      case ManualBlockKind::paragraph: return place_text(0.0);
      case ManualBlockKind::item:
        return place_text(kItemIndent * metrics_.unit * static_cast<double>(block.level + 1));
      case ManualBlockKind::code: return place_code(block);
      case ManualBlockKind::head: fit_columns(); return place_row(block);
      case ManualBlockKind::row: return place_row(block);
    }
  }

  void place_text(double left) { y_ = place_cell(block_, 0, {left, y_}, metrics_.width).y; }

  // Words of code begin at their columns, or in a new line where the words before reach too far.
  void place_code(const ManualBlock& block) {
    if (ends_run(block, -1)) fit_code();
    const double left = kCodeIndent * metrics_.unit;
    const double height = metrics_.line(ManualStyle::plain);
    Position end{left, y_};
    for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
      const double x = left + code_step_ * static_cast<double>(block.cells[cell].column);
      if (cell > 0 && end.x + code_step_ > x) end.y += height;
      end = place_cell(block_, cell, {x, end.y}, metrics_.width - left);
      end.y -= height;
    }
    y_ = end.y + height;
  }

  void fit_code() {
    std::size_t last = 1;
    for (std::size_t i = block_; i < manual_.blocks.size() && manual_.blocks[i].kind == ManualBlockKind::code; ++i)
      last = std::max(last, manual_.blocks[i].cells.back().column);
    code_step_ = std::min(kCodeColumn * metrics_.line(ManualStyle::plain),
                          kLargestStart * metrics_.width / static_cast<double>(last));
  }

  void place_row(const ManualBlock& block) {
    const double padding = kCellPadding * metrics_.unit;
    if (columns_.empty()) return place_stacked_row(block);
    double bottom = y_ + metrics_.line(ManualStyle::plain) + 2.0 * padding;
    double x = 0.0;
    for (std::size_t cell = 0; cell < std::min(block.cells.size(), columns_.size()); ++cell) {
      bottom = std::max(bottom, place_cell(block_, cell, {x, y_ + padding}, x + columns_[cell]).y + padding);
      x += columns_[cell] + kBetweenColumns * metrics_.unit;
    }
    y_ = bottom;
  }

  // The first cell names its row, so it needs no title.
  void place_stacked_row(const ManualBlock& block) {
    const double padding = kCellPadding * metrics_.unit;
    const ManualBlock& head = manual_.blocks[head_];
    y_ += padding;
    for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
      if (block.cells[cell].text.empty()) continue;
      Position start{cell > 0 ? kItemIndent * metrics_.unit : 0.0, y_};
      if (cell > 0 && head_ != block_ && cell < head.cells.size() && !head.cells[cell].text.empty()) {
        const Position end = place_cell(head_, cell, start, metrics_.width);
        const double height = metrics_.line(ManualStyle::plain);
        // A title that leaves no room has the text below it.
        if (end.x <= kLargestStart * metrics_.width && end.y < y_ + 1.5 * height)
          start.x = end.x + 0.5 * kBetweenColumns * metrics_.unit;
        else
          start.y = end.y;
      }
      y_ = place_cell(block_, cell, start, metrics_.width).y;
    }
    y_ += padding;
  }

  /// Gives each column of the table that begins here its width: what its longest word needs, and a part of the rest in
  /// proportion to what it lacks to be on one line. There are no columns if the page is too narrow for the words.
  void fit_columns() {
    head_ = block_;
    std::vector<double> least;
    std::vector<double> most;
    for (std::size_t i = block_; i < manual_.blocks.size(); ++i) {
      const ManualBlock& row = manual_.blocks[i];
      if (i > block_ && row.kind != ManualBlockKind::row) break;
      least.resize(std::max(least.size(), row.cells.size()), 0.0);
      most.resize(least.size(), 0.0);
      for (std::size_t cell = 0; cell < row.cells.size(); ++cell) {
        most[cell] = std::max(most[cell], measure(row, cell, 0, row.cells[cell].text.size()));
        for_each_word(row.cells[cell].text, [&](std::size_t begin, std::size_t end) {
          least[cell] = std::max(least[cell], measure(row, cell, begin, end));
        });
      }
    }
    const auto gaps = static_cast<double>(least.size() - 1) * kBetweenColumns * metrics_.unit;
    const double room = std::max(0.0, metrics_.width - gaps);
    const double all_least = std::accumulate(least.begin(), least.end(), 0.0);
    const double all_most = std::accumulate(most.begin(), most.end(), 0.0);
    if (all_most <= room) {
      columns_ = std::move(most);
    } else if (all_least >= room) {
      columns_.clear();
    } else {
      columns_ = least;
      for (std::size_t i = 0; i < columns_.size(); ++i)
        columns_[i] += (room - all_least) * (most[i] - least[i]) / (all_most - all_least);
    }
  }

  template <class Visit>
  static void for_each_word(std::string_view text, Visit visit) {
    std::size_t at = text.find_first_not_of(' ');
    while (at < text.size()) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      visit(at, end);
      at = text.find_first_not_of(' ', end);
    }
  }

  double measure(const ManualBlock& block, std::size_t cell, std::size_t begin, std::size_t end) const {
    const ManualCell& of = block.cells[cell];
    double out = 0.0;
    for_each_style(of, block.style(), begin, end, [&](std::size_t from, std::size_t to, ManualStyle style) {
      out += metrics_.measure(std::string_view(of.text).substr(from, to - from), style);
    });
    return out;
  }

  struct Position {
    double x = 0.0;
    double y = 0.0;
  };

  /// Places the text between the corner and `right`; returns the end of its last line, and the bottom of that line.
  Position place_cell(std::size_t source, std::size_t cell, Position corner, double right) {
    const ManualBlock& block = manual_.blocks[source];
    const std::string_view text = block.cells[cell].text;
    const double height = metrics_.line(block.style());
    // Widths are sums of rounded numbers, so a column that is as wide as its text may be too narrow by a rounding.
    const double limit = right + 1e-6 * std::abs(right);
    Position at = corner;
    std::size_t line_begins = out_.pieces.size();
    std::size_t written = 0;
    const auto new_line = [&](std::size_t next) {
      at = {corner.x, at.y + height};
      line_begins = out_.pieces.size();
      written = next;
    };
    for_each_word(text, [&](std::size_t begin, std::size_t end) {
      const bool is_first = out_.pieces.size() == line_begins;
      if (!is_first && at.x + measure(block, cell, written, end) > limit) new_line(begin);
      if (out_.pieces.size() == line_begins) written = begin;
      // A word that is wider than the line is broken between its letters.
      while (at.x + measure(block, cell, written, end) > limit) {
        std::size_t fits = end_of_letter(text, begin);
        if (fits >= end) break;
        for (std::size_t next = end_of_letter(text, fits);
             next < end && at.x + measure(block, cell, written, next) <= limit; next = end_of_letter(text, next))
          fits = next;
        at.x = write(source, cell, written, fits, at, line_begins);
        begin = fits;
        new_line(fits);
      }
      at.x = write(source, cell, written, end, at, line_begins);
      written = end;
    });
    return {at.x, at.y + height};
  }

  /// Appends the text to the line; returns its end.
  double write(std::size_t source, std::size_t cell, std::size_t begin, std::size_t end, Position at,
               std::size_t line_begins) {
    const ManualBlock& block = manual_.blocks[source];
    const std::string_view text = block.cells[cell].text;
    for_each_style(block.cells[cell], block.style(), begin, end,
                   [&](std::size_t from, std::size_t to, ManualStyle style) {
                     const double width = metrics_.measure(text.substr(from, to - from), style);
                     std::vector<ManualPiece>& pieces = out_.pieces;
                     if (pieces.size() > line_begins && pieces.back().style == style && pieces.back().end == from) {
                       pieces.back().end = to;
                       pieces.back().width += width;
                     } else {
                       pieces.push_back({source, cell, from, to, style, at.x, at.y, width});
                     }
                     at.x += width;
                   });
    return at.x;
  }

  const ManualText& manual_;
  const ManualMetrics& metrics_;
  ManualLayout out_;
  std::size_t block_ = 0;
  double y_ = 0.0;
  std::size_t head_ = 0;         // the titles of the present table
  std::vector<double> columns_;  // of the present table; empty: its rows are stacked
  double code_step_ = 0.0;       // width of a letter in the present block of code
};

}  // namespace

std::pair<std::size_t, std::size_t> ManualLayout::blocks_between(double top, double bottom) const {
  const auto end = blocks.end() - 1;
  const auto first = std::partition_point(blocks.begin(), end, [top](const Block& one) { return one.bottom < top; });
  const auto last = std::partition_point(first, end, [bottom](const Block& one) { return one.top <= bottom; });
  return {static_cast<std::size_t>(first - blocks.begin()), static_cast<std::size_t>(last - blocks.begin())};
}

const ManualPiece& ManualLayout::piece_of(const ManualFind& find) const {
  const std::span<const ManualPiece> of_block(
      pieces.begin() + static_cast<std::ptrdiff_t>(blocks[find.block].first_piece),
      pieces.begin() + static_cast<std::ptrdiff_t>(blocks[find.block + 1].first_piece));
  MES_ASSERT(!of_block.empty());
  const auto found = std::ranges::find_if(of_block, [&](const ManualPiece& piece) {
    return piece.block == find.block && piece.cell == find.cell && piece.end > find.begin;
  });
  return found == of_block.end() ? of_block.back() : *found;
}

ManualLayout lay_out(const ManualText& manual, const ManualMetrics& metrics) {
  return LayoutMaker(manual, metrics).make();
}

}  // namespace mes

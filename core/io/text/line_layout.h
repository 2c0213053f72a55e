// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks the layout of numbers on lines. Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mes {

/// White space is free in POFF and WPOFF, so any numbers can be read as pairs; but a file with three numbers on every
/// line does not hold points. This class records positions of numbers and finds lines that contradict the reading.
///
/// Smallest use:
///     LineLayout layout(2, header_line);
///     for (const auto& number : numbers) layout.add(number.line, number.column, number.length);
///     layout.end();
///     if (const auto line = layout.contradiction(announced)) refuse(*line);
///
/// Cost: constant time a number, constant memory.
class LineLayout {
 public:
  /// Numbers on the header line belong to no layout: such a file distributes its numbers freely.
  LineLayout(std::size_t numbers_each, std::uint64_t header_line) : each_(numbers_each), header_line_(header_line) {}

  /// Adds the next number of the file.
  void add(std::uint64_t line, std::uint64_t column, std::size_t length) {
    if (line != line_) begin_line(line);
    ++numbers_;
    if (++columns_ == each_ + 1) extra_ = {line, column};
    end_of_line_ = {line, column + length};
  }
  /// Marks the end of the file.
  void end() { end_line(); }

  struct Place {
    std::uint64_t line = 0;
    std::uint64_t column = 0;
  };
  /// A line with a number of columns other than `numbers_each`; its position is the first surplus number, or the end of
  /// the line.
  struct OddLine {
    Place place;
    std::size_t columns = 0;
    bool are_all_alike = false;  ///< every line has this many columns; else this line stands out
  };
  /// Lines contradict free reading in two cases:
  ///  1. All lines, at least two, have the same number of columns, which is neither one nor a multiple of
  ///     `numbers_each`. The last line may be shorter, unless the count of numbers is exactly as announced.
  ///  2. There are as many lines as things, the count of numbers is not as announced, and a line before the last is
  ///     odd.
  std::optional<OddLine> contradiction(std::uint64_t announced_things) const;
  /// Whether no further number can cause the first case.
  bool is_free() const { return is_free_ || !is_steady_; }

 private:
  void begin_line(std::uint64_t line);
  void end_line();

  std::size_t each_;
  std::uint64_t header_line_;
  std::uint64_t numbers_ = 0;
  bool is_free_ = false;
  // State of the current line.
  std::uint64_t line_ = 0;
  std::size_t columns_ = 0;
  Place extra_{};
  Place end_of_line_{};
  // State of all complete lines.
  std::uint64_t lines_ = 0;
  OddLine first_{};
  bool is_steady_ = true;  ///< all lines have as many numbers as the first; the last may have fewer
  bool last_is_shorter_ = false;
  std::optional<OddLine> odd_;
  std::uint64_t odd_index_ = 0;
};

}  // namespace mes

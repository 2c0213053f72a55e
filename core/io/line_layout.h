// SPDX-License-Identifier: GPL-3.0-or-later
// How the numbers of a text lie on its lines. Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mes {

/// White space is free in POFF and WPOFF, so pairs can be made of any numbers; a file whose lines all have three
/// numbers holds no points all the same. This notes where numbers stand and says which line contradicts the reading.
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
  /// Numbers on the line of the header are part of no layout: such a file spreads its numbers freely.
  LineLayout(std::size_t numbers_each, std::uint64_t header_line) : each_(numbers_each), header_line_(header_line) {}

  /// The next number of the file.
  void add(std::uint64_t line, std::uint64_t column, std::size_t length) {
    if (line != line_) begin_line(line);
    ++numbers_;
    if (++columns_ == each_ + 1) extra_ = {line, column};
    end_of_line_ = {line, column + length};
  }
  /// The file ends here.
  void end() { end_line(); }

  struct Place {
    std::uint64_t line = 0;
    std::uint64_t column = 0;
  };
  /// A line that holds something other than `numbers_each` numbers: the first number too many, or the end of the
  /// line.
  struct OddLine {
    Place place;
    std::size_t columns = 0;
    bool are_all_alike = false;  ///< every line has that many; else this one stands out
  };
  /// Lines contradict free reading in two cases:
  ///  1. All, and two at least, have the same number of columns, which is neither one nor makes whole things. The
  ///     last may be shorter, unless the numbers are exactly as many as announced.
  ///  2. There are as many lines as things, not as many numbers as announced, and a line before the last differs.
  std::optional<OddLine> contradiction(std::uint64_t announced_things) const;
  /// No further number can bring about the first case.
  bool is_free() const { return is_free_ || !is_steady_; }

 private:
  void begin_line(std::uint64_t line);
  void end_line();

  std::size_t each_;
  std::uint64_t header_line_;
  std::uint64_t numbers_ = 0;
  bool is_free_ = false;
  // Of the present line.
  std::uint64_t line_ = 0;
  std::size_t columns_ = 0;
  Place extra_{};
  Place end_of_line_{};
  // Of those that have ended.
  std::uint64_t lines_ = 0;
  OddLine first_{};
  bool is_steady_ = true;  ///< as many numbers as in the first line; the last may have fewer
  bool last_is_shorter_ = false;
  std::optional<OddLine> odd_;
  std::uint64_t odd_index_ = 0;
};

}  // namespace mes

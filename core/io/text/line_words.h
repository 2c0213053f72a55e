// SPDX-License-Identifier: GPL-3.0-or-later
// Line-based texts: the words of a line, and messages with positions. Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/io/text/read_job.h"
#include "core/io/text/text_numbers.h"

namespace mes {

/// Iterates over the lines that contain words. Words are separated by blanks; `#` begins a comment up to the end of its
/// line. Lines end at LF, CR LF or a lone CR. With `Lines::continued`, a backslash at its end continues a line.
///
/// Smallest use:
///     LineWords lines(bytes, name);
///     while (lines.next()) {
///       const auto position = lines.position(0);
///       if (!position) return std::unexpected(position.error());
///     }
///
/// Cost: linear; memory for the words of one line.
class LineWords {
 public:
  enum class Lines : std::uint8_t { as_they_are, continued };
  /// `job`, which may be null, follows the bytes.
  LineWords(std::string_view bytes, const std::string& name, ReadJob* job = nullptr,
            Lines lines = Lines::as_they_are);

  /// Advances to the next line with a word; false at the end, and the position is then the end. Throws `Cancelled`.
  bool next();
  std::span<const std::string_view> words() const { return words_; }
  std::size_t count() const { return words_.size(); }
  /// A word of the line, or nothing.
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : std::string_view{}; }
  /// Number of the line; for a continued line, of its last one.
  std::uint64_t line() const { return line_; }
  /// The bytes after this line.
  std::string_view rest() const { return rest_; }

  /// Makes an error at a word, or at the end of the line if there is no such word.
  std::unexpected<Error> refuse(std::size_t i, std::string text) const;
  /// Makes a one-line remark at a word.
  std::string remark(std::size_t i, std::string text) const { return refuse(i, std::move(text)).error().message(); }

  /// Parses a decimal integer without sign. `what` names the quantity in messages.
  Expected<std::uint64_t> whole(std::size_t i, std::string_view what) const;
  /// Parses a finite number that is not a coordinate of the document, such as a height.
  Expected<double> number(std::size_t i, std::string_view what) const;
  /// Parses two words from `i` on as x and y, in range together with all previous positions.
  Expected<Vec2> position(std::size_t i);

 private:
  std::string_view rest_;
  std::string_view text_;
  const std::string& name_;
  ReadJob* job_;
  Lines lines_;
  std::vector<std::string_view> words_;
  std::uint64_t line_ = 0;
  CoordinateReader coordinates_;
};

}  // namespace mes

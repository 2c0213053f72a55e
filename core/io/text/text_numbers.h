// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in text, independent of the locale, and error texts for them.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/geometry/coordinate_range.h"

namespace mes {

enum class NumberFault : std::uint8_t { not_a_number, not_finite, too_large };

/// A finite double that takes up the whole token. A leading plus and a Fortran D exponent are allowed, hexadecimal and
/// infinity are not; numbers too small for a double become zero. Cost: about 50 ns, no allocation unless a decimal
/// comma is replaced.
std::expected<double, NumberFault> parse_number(std::string_view token, bool decimal_comma = false);

/// Reads the coordinates and radii of one document, whose range limits each of them and all of them together.
class CoordinateReader {
 public:
  /// The number, or a one-line reason why it is invalid. Cost: as `parse_number`.
  std::expected<double, std::string> read(std::string_view token, bool decimal_comma = false);

 private:
  Magnitudes seen_;
};

/// A decimal integer without sign that takes up the whole token.
std::expected<std::uint64_t, NumberFault> parse_count(std::string_view token);

/// One line that tells why the token is not a valid number.
std::string describe(NumberFault fault, std::string_view token);

/// The token between double quotes for a message: at most about 40 characters, nothing unprintable.
std::string in_quotes(std::string_view token);

/// The text with everything unprintable escaped, of any length; UTF-8 passes.
std::string printable(std::string_view text);

/// Shortest decimal form that reads back as the same double.
void append_number(std::string& out, double value);

inline std::unexpected<Error> bad_input(std::string text, const std::string& file, std::uint64_t line,
                                        std::uint64_t column) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file, line, column});
}

/// Iterates over words between white space, without `#` comments, and knows its position.
///
/// Lines end at LF, CR LF or a lone CR. Cost: reads each byte once.
///
/// Smallest use:
///     Scanner scanner(bytes);
///     while (scanner.next()) use(scanner.token(), scanner.line(), scanner.column());
class Scanner {
 public:
  explicit Scanner(std::string_view bytes);
  virtual ~Scanner() = default;

  /// Advances to the next word; false at the end, where line and column are those of the end.
  bool next();
  std::string_view token() const { return token_; }
  std::uint64_t line() const { return line_; }
  std::uint64_t column() const { return column_of(token_.data()); }

 protected:
  /// Column of a byte of the current line.
  std::uint64_t column_of(const char* at) const { return static_cast<std::uint64_t>(at - line_start_) + 1; }
  /// Called with the text after the `#`, up to the end of its line.
  virtual void on_comment(std::string_view /*text*/) {}

 private:
  const char* at_;
  const char* end_;
  const char* line_start_;
  std::uint64_t line_ = 1;
  std::string_view token_;
};

/// The bytes without a UTF-8 byte order mark.
std::string_view without_bom(std::string_view bytes);

inline constexpr std::string_view kUtf16Text = "UTF-16 text";

/// Name of the format if the bytes are clearly not a text of samples ("a PNG picture", "binary data"); empty otherwise.
/// Reads only the first few kilobytes.
std::string_view foreign_kind(std::string_view bytes);

}  // namespace mes

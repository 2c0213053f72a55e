// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/text_numbers.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "core/io/text/ascii_text.h"
#include "core/io/text/short_decimal.h"

namespace mes {
namespace {

constexpr std::size_t kQuotedLength = 40;

// Whether an out-of-range number is too near zero rather than too large: adds the exponent to the position of the first
// nonzero digit. Exponents saturate, so that their own size does not matter.
bool is_tiny(std::string_view token) {
  std::size_t mantissa_end = token.find_first_of("eE");
  long long exponent = 0;
  if (mantissa_end == std::string_view::npos) {
    mantissa_end = token.size();
  } else {
    std::string_view digits = token.substr(mantissa_end + 1);
    const bool negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    for (const char c : digits) exponent = std::min(10 * exponent + (c - '0'), 1'000'000'000'000LL);
    if (negative) exponent = -exponent;
  }
  const std::string_view mantissa = token.substr(0, mantissa_end);
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  return static_cast<long long>(dot) - static_cast<long long>(first) + exponent < 0;
}

// Length of a UTF-8 sequence that starts at `i`; 0 if it is invalid or stands for a control character.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(i);
  const std::size_t length = lead >= 0xF0 && lead <= 0xF4   ? 4
                             : lead >= 0xE0 && lead <= 0xEF ? 3
                             : lead >= 0xC2 && lead <= 0xDF ? 2
                                                            : 0;
  if (length == 0 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xC0U) != 0x80) return 0;
  // C1 controls; surrogates, overlong forms and codes beyond Unicode; line and paragraph separators, and marks that
  // change the direction of writing.
  if (lead == 0xC2 && byte(i + 1) < 0xA0) return 0;
  if (lead == 0xE0 && byte(i + 1) < 0xA0) return 0;
  if (lead == 0xED && byte(i + 1) >= 0xA0) return 0;
  if (lead == 0xF0 && byte(i + 1) < 0x90) return 0;
  if (lead == 0xF4 && byte(i + 1) >= 0x90) return 0;
  if (lead == 0xE2 && byte(i + 1) == 0x80 && byte(i + 2) >= 0xA8 && byte(i + 2) <= 0xAE) return 0;
  if (lead == 0xE2 && byte(i + 1) == 0x81 && byte(i + 2) >= 0xA6 && byte(i + 2) <= 0xA9) return 0;
  return length;
}

/// "1.5D+3": a number, then D, perhaps a sign, and digits.
bool is_fortran_exponent(std::string_view token, const char* end) {
  std::string_view rest(end, token.data() + token.size());
  if (!rest.starts_with('D') && !rest.starts_with('d')) return false;
  rest.remove_prefix(1);
  if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
  return !rest.empty() && std::ranges::all_of(rest, is_digit) && is_digit(token[token.size() - 1]);
}

void append_escaped(std::string& out, char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  out += "\\x";
  out += kDigits[byte >> 4U];
  out += kDigits[byte & 15U];
}

}  // namespace

std::expected<double, NumberFault> parse_number(std::string_view token, bool decimal_comma) {
  if (decimal_comma && token.contains(',')) {
    std::string with_point(token);
    std::ranges::replace(with_point, ',', '.');
    if (token.contains('.')) return std::unexpected(NumberFault::not_a_number);
    return parse_number(with_point, false);
  }
  if (token.starts_with('+') && token.size() > 1 && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  double value = 0.0;
  // For more bytes than this the digits are mostly above 2^53: reading them twice would be slower than `from_chars`
  // alone.
  constexpr std::size_t kMostShort = 18;
  if (!token.empty() && token.size() <= kMostShort && short_decimal(token, value) == token.size()) return value;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc::invalid_argument && is_fortran_exponent(token, end)) {
    std::string with_e(token);
    with_e[static_cast<std::size_t>(end - token.data())] = 'e';
    return parse_number(with_e, false);
  }
  if (error == std::errc::invalid_argument || end != token.data() + token.size())
    return std::unexpected(NumberFault::not_a_number);
  if (error == std::errc::result_out_of_range) {
    if (is_tiny(token)) return 0.0;
    return std::unexpected(NumberFault::too_large);
  }
  if (!std::isfinite(value)) {
    // Some libraries return infinity instead of an error for numbers out of range.
    const bool has_digits = std::ranges::any_of(token, is_digit) && !token.contains('n') && !token.contains('N');
    return std::unexpected(has_digits ? NumberFault::too_large : NumberFault::not_finite);
  }
  return value;
}

std::expected<double, std::string> CoordinateReader::read(std::string_view token, bool decimal_comma) {
  const auto value = parse_number(token, decimal_comma);
  if (!value && value.error() == NumberFault::too_large)
    return std::unexpected(describe(RangeFault::too_large, in_quotes(token)));
  if (!value) return std::unexpected(describe(value.error(), token));
  auto fault = seen_.fault_of(*value);
  // A number nearer to zero than any double is not zero.
  if (*value == 0.0 && token.substr(0, token.find_first_of("eE")).find_first_of("123456789") != token.npos)
    fault = RangeFault::too_small;
  if (fault) return std::unexpected(describe(*fault, in_quotes(token), seen_));
  seen_.add(*value);
  return *value;
}

std::expected<std::uint64_t, NumberFault> parse_count(std::string_view token) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument)
    return std::unexpected(NumberFault::not_a_number);
  if (error == std::errc::result_out_of_range) return std::unexpected(NumberFault::too_large);
  return value;
}

std::string describe(NumberFault fault, std::string_view token) {
  switch (fault) {
    case NumberFault::not_a_number: return "expected a number, found " + in_quotes(token);
    case NumberFault::not_finite: return in_quotes(token) + " is not a finite number";
    case NumberFault::too_large: return in_quotes(token) + " is too large";
  }
  return {};
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c >= ' ' && c <= '~') {
      out += c;
      ++i;
    } else if (const std::size_t length = utf8_length(text, i); length != 0) {
      out += text.substr(i, length);
      i += length;
    } else {
      append_escaped(out, c);
      ++i;
    }
  }
  return out;
}

std::string in_quotes(std::string_view token) {
  if (token.size() <= kQuotedLength) return '"' + printable(token) + '"';
  std::size_t cut = kQuotedLength - 3;
  while (cut > 0 && (static_cast<unsigned char>(token[cut]) & 0xC0U) == 0x80) --cut;
  return fmt::format(R"("{}..." ({} characters))", printable(token.substr(0, cut)), token.size());
}

void append_number(std::string& out, double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), error == std::errc() ? end : digits.data());
}

Scanner::Scanner(std::string_view bytes) {
  const std::string_view text = without_bom(bytes);
  at_ = line_start_ = text.data();
  end_ = at_ + text.size();
  token_ = text.substr(0, 0);
}

bool Scanner::next() {
  while (at_ != end_) {
    const char c = *at_;
    if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
      ++at_;
    } else if (c == '\n' || c == '\r') {
      ++at_;
      if (c == '\r' && at_ != end_ && *at_ == '\n') ++at_;
      line_start_ = at_;
      ++line_;
    } else if (c == '#') {
      const char* begin = ++at_;
      while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
      on_comment({begin, at_});
    } else {
      const char* begin = at_;
      const auto is_blank = [](char d) { return d == ' ' || (d >= '\t' && d <= '\r') || d == '#'; };
      while (at_ != end_ && !is_blank(*at_)) ++at_;
      token_ = {begin, at_};
      return true;
    }
  }
  token_ = {end_, end_};
  return false;
}

std::string_view without_bom(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return bytes;
}

namespace {

/// In UTF-16, each character of a sample file has a zero byte.
bool is_utf16_without_mark(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 64;
  const std::string_view beginning = bytes.substr(0, std::min(kLookedAt, bytes.size() & ~std::size_t{1}));
  const auto is_in_halves = [&](std::size_t low) {
    for (std::size_t i = 0; i < beginning.size(); ++i)
      if ((beginning[i] == '\0') != (i % 2 != low)) return false;
    return true;
  };
  return beginning.size() >= 4 && (is_in_halves(0) || is_in_halves(1));
}

}  // namespace

namespace {

/// Formats of maps, drawings and pictures that users may try.
std::string_view binary_kind(std::string_view bytes) {
  using namespace std::string_view_literals;
  using Entry = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Entry, 7> kBeginnings{{{"SQLite format 3"sv, "an SQLite database, such as a GeoPackage"},
                                              {"II*\0"sv, "a TIFF picture"},
                                              {"MM\0*"sv, "a TIFF picture"},
                                              {"AC10"sv, "a DWG drawing"},
                                              {"fgb"sv, "a FlatGeobuf map"},
                                              {"glTF"sv, "a glTF mesh"},
                                              {"RIFF"sv, "a WebP picture or a sound"}}};
  for (const auto& [beginning, kind] : kBeginnings)
    if (bytes.starts_with(beginning)) return kind;
  return "binary data";
}

}  // namespace

std::string_view foreign_kind(std::string_view bytes) {
  using Entry = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Entry, 10> kBeginnings{{{"\x89PNG", "a PNG picture"},
                                               {"\xFF\xD8\xFF", "a JPEG picture"},
                                               {"GIF8", "a GIF picture"},
                                               {"%PDF", "a PDF document"},
                                               {"%!PS", "a PostScript document"},
                                               {"PK\x03\x04", "a zip archive"},
                                               {"\x1F\x8B", "gzip compressed data"},
                                               {"\x7F"
                                                "ELF",
                                                "a program"},
                                               {"\xFF\xFE", kUtf16Text},
                                               {"\xFE\xFF", kUtf16Text}}};
  for (const auto& [beginning, kind] : kBeginnings)
    if (without_bom(bytes).starts_with(beginning)) return kind;
  if (is_utf16_without_mark(bytes)) return kUtf16Text;
  if (without_bom(bytes).starts_with('<')) return "XML";
  constexpr std::size_t kLookedAt = 8192;
  const std::string_view beginning = bytes.substr(0, kLookedAt);
  return beginning.contains('\0') ? binary_kind(beginning) : std::string_view{};
}

}  // namespace mes

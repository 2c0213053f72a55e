// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/pictures/netpbm.h"

#include <fmt/core.h>
#include <algorithm>
#include <optional>

namespace mes {
namespace {

constexpr std::uint32_t kMostValue = 65535;

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Skips white space and comments.
void skip_blanks(std::string_view& rest) {
  while (!rest.empty() && (is_blank(rest.front()) || rest.front() == '#')) {
    const std::size_t size = rest.front() == '#' ? std::min(rest.find_first_of("\r\n"), rest.size()) : 1;
    rest.remove_prefix(size);
  }
}

/// Takes a number; nothing if there is none or it has many digits.
std::optional<std::uint32_t> take_number(std::string_view& rest) {
  constexpr std::size_t kMostDigits = 6;
  skip_blanks(rest);
  std::size_t digits = 0;
  std::uint32_t out = 0;
  for (; !rest.empty() && is_digit(rest.front()); rest.remove_prefix(1), ++digits)
    if (digits < kMostDigits) out = 10 * out + static_cast<std::uint32_t>(rest.front() - '0');
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  return out;
}

struct Layout {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 1;
  std::uint32_t most = 1;  ///< the largest value
  bool is_plain = false;
  bool has_bits = false;  ///< each value is one bit
  bool one_is_black = false;
  std::size_t row() const { return width * channels; }
  std::size_t bytes_of_a_row() const { return has_bits ? (width + 7) / 8 : row() * (most > 255 ? 2U : 1U); }
};

/// Takes the header off the front, with the one blank after it. Nothing for an invalid header.
std::optional<Layout> take_header(std::string_view& rest) {
  const char kind = rest[1];
  rest.remove_prefix(2);
  const auto width = take_number(rest);
  const auto height = take_number(rest);
  const bool is_bitmap = kind == '1' || kind == '4';
  const auto most = is_bitmap ? 1U : take_number(rest);
  if (!width || !height || !most || *most == 0 || *most > kMostValue) return std::nullopt;
  const bool is_plain = kind <= '3';
  if (!is_plain) rest.remove_prefix(std::min<std::size_t>(rest.size(), 1));
  return Layout{.width = *width,
                .height = *height,
                .channels = kind == '3' || kind == '6' ? 3U : 1U,
                .most = *most,
                .is_plain = is_plain,
                .has_bits = is_bitmap,
                .one_is_black = is_bitmap};
}

/// Takes the header lines of a PAM, up to ENDHDR.
std::optional<Layout> take_pam_header(std::string_view& rest) {
  Layout out{.channels = 0, .most = 0};
  rest.remove_prefix(2);
  for (;;) {
    skip_blanks(rest);
    const std::size_t size = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    const std::string_view word = rest.substr(0, size);
    if (word.empty()) return std::nullopt;
    rest.remove_prefix(size);
    if (word == "ENDHDR") break;
    if (word == "TUPLTYPE") {
      rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
      continue;
    }
    const auto number = take_number(rest);
    if (!number) return std::nullopt;
    if (word == "WIDTH") out.width = *number;
    if (word == "HEIGHT") out.height = *number;
    if (word == "DEPTH") out.channels = *number;
    if (word == "MAXVAL") out.most = *number;
  }
  constexpr std::size_t kMostChannels = 4;
  if (out.channels == 0 || out.channels > kMostChannels || out.most == 0 || out.most > kMostValue)
    return std::nullopt;
  rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
  rest.remove_prefix(std::min<std::size_t>(rest.size(), 1));
  return out;
}

/// Scales to 8 bits; of 16 bits takes the upper ones, like other formats.
std::uint8_t scaled(std::uint32_t value, std::uint32_t most) {
  if (most == kMostValue) return static_cast<std::uint8_t>(value >> 8U);
  return static_cast<std::uint8_t>((std::min(value, most) * 255U + most / 2) / most);
}

/// The values of a plain picture, as many as are valid; `fault` tells of an invalid one.
std::vector<std::uint8_t> plain_values(std::string_view rest, const Layout& layout, std::string& fault) {
  const std::size_t count = layout.row() * layout.height;
  std::vector<std::uint8_t> out;
  out.reserve(std::min(count, rest.size()));
  while (out.size() < count) {
    skip_blanks(rest);
    if (rest.empty()) break;
    // Bits need no blank between them.
    std::string_view number = layout.has_bits ? rest.substr(0, 1) : rest;
    const std::size_t before = number.size();
    const auto value = take_number(number);
    if (!value || *value > (layout.has_bits ? 1U : kMostValue)) {
      fault = fmt::format("there is no {} in row {} of {}", layout.has_bits ? "0 or 1" : "grey value or colour",
                          out.size() / layout.row() + 1, layout.height);
      break;
    }
    rest.remove_prefix(before - number.size());
    out.push_back(scaled(*value, layout.most));
  }
  return out;
}

std::vector<std::uint8_t> binary_values(std::string_view rest, const Layout& layout) {
  const auto byte = [&](std::size_t i) -> unsigned { return static_cast<std::uint8_t>(rest[i]); };
  const std::size_t count = layout.row() * layout.height;
  std::vector<std::uint8_t> out(count);
  if (layout.has_bits) {
    for (std::size_t y = 0, i = 0; y < layout.height; ++y)
      for (std::size_t x = 0; x < layout.width; ++x, ++i)
        out[i] = (byte(y * layout.bytes_of_a_row() + x / 8) >> (7 - x % 8) & 1U) != 0 ? 255 : 0;
  } else if (layout.most > 255) {
    for (std::size_t i = 0; i < count; ++i) out[i] = scaled(byte(2 * i) << 8U | byte(2 * i + 1), layout.most);
  } else {
    for (std::size_t i = 0; i < count; ++i) out[i] = scaled(byte(i), layout.most);
  }
  return out;
}

}  // namespace

bool looks_like_netpbm(std::string_view bytes) {
  if (bytes.size() < 3 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '7') return false;
  std::string_view rest = bytes.substr(2);
  if (bytes[1] == '7') return rest.starts_with('\n') || rest.starts_with("\r\n");
  if (!is_blank(rest.front()) && rest.front() != '#') return false;
  if (bytes[1] > '3') return is_blank(rest.front());
  if (!take_number(rest) || rest.empty() || (!is_blank(rest.front()) && rest.front() != '#')) return false;
  return take_number(rest) && (rest.empty() || is_blank(rest.front()) || rest.front() == '#');
}

Expected<Pixels> decode_netpbm(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
  const auto fail = [&](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), name});
  };
  std::string_view rest = bytes;
  const bool is_pam = bytes[1] == '7';
  const auto layout = is_pam ? take_pam_header(rest) : take_header(rest);
  if (!layout) {
    const std::string_view kind = is_pam ? "PAM" : bytes[1] == '1' || bytes[1] == '4' ? "PBM" : "PGM or PPM";
    return fail(fmt::format("the picture is broken: its header is not that of a {}", kind));
  }
  const std::string extent = fmt::format("{}x{}", layout->width, layout->height);
  if (layout->width == 0 || layout->height == 0) return fail("the picture is broken: it has " + extent + " pixels");
  const std::size_t count = layout->row() * layout->height;
  const std::size_t least = !layout->is_plain  ? layout->bytes_of_a_row() * layout->height
                            : layout->has_bits ? count
                                               : 2 * count - 1;
  constexpr auto kLongest = static_cast<std::size_t>(kLongestPictureSide);
  const bool is_large =
      layout->width > kLongest || layout->height > kLongest || layout->width * layout->height > most_pixels;
  // Missing pixels are reported as such.
  if (is_large && rest.size() >= least) return fail("a picture of " + extent + " pixels is too large to trace");
  const auto ends_in_row = [&](std::size_t row) {
    return fail(fmt::format("the picture is broken: the file ends in row {} of {}", row + 1, layout->height));
  };
  Pixels out{static_cast<int>(layout->width), static_cast<int>(layout->height), static_cast<int>(layout->channels)};
  if (layout->is_plain) {
    std::string fault;
    out.values = plain_values(rest, *layout, fault);
    if (!fault.empty()) return fail("the picture is broken: " + fault);
    if (out.values.size() < count) return ends_in_row(out.values.size() / layout->row());
  } else {
    const std::size_t row = layout->bytes_of_a_row();
    if (rest.size() < row * layout->height) return ends_in_row(rest.size() / row);
    out.values = binary_values(rest, *layout);
  }
  if (layout->one_is_black)
    for (std::uint8_t& value : out.values) value = static_cast<std::uint8_t>(255 - value);
  return out;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/picture.h"

#include <fmt/core.h>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "app/cli/console/messages.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::uint64_t kLongestSide = 32768;

/// Reads exactly this many numbers, separated by commas.
bool read_numbers(std::string_view text, std::span<double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == numbers.size())) return false;
    const auto value = parse_number(text.substr(0, comma));
    if (!value) return false;
    numbers[i] = *value;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return true;
}

}  // namespace

Expected<PictureSize> parse_size(const std::string& text) {
  const std::size_t cross = text.find_first_of("xX");
  const auto side = [](std::string_view digits) -> int {
    const auto value = parse_count(digits);
    return value && *value >= 1 && *value <= kLongestSide ? static_cast<int>(*value) : 0;
  };
  if (cross != std::string::npos) {
    const PictureSize size{side(std::string_view(text).substr(0, cross)),
                           side(std::string_view(text).substr(cross + 1))};
    if (size.width != 0 && size.height != 0) return size;
  }
  return usage_error(fmt::format("--size expects WxH, each from 1 to {}, not {}", kLongestSide, in_quotes(text)));
}

Expected<std::optional<Box2>> parse_view(const std::string& text) {
  if (text == "fit") return std::nullopt;
  std::array<double, 4> corner{};
  bool good = read_numbers(text, corner);
  Box2 box;
  if (good) {
    box.add(Vec2{corner[0], corner[1]});
    box.add(Vec2{corner[2], corner[3]});
    good = box.width() > 0.0 && box.height() > 0.0 && std::isfinite(box.width()) && std::isfinite(box.height());
  }
  if (!good) return usage_error("--view expects fit or two corners X0,Y0,X1,Y1, not " + in_quotes(text));
  return box;
}

std::optional<Rgb> parse_rgb(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  if (text.size() != 6) return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::size_t digit = kDigits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    if (digit == std::string_view::npos) return std::nullopt;
    value = value * 16 + static_cast<std::uint32_t>(digit);
  }
  return Rgb{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
             static_cast<std::uint8_t>(value)};
}

Expected<std::optional<Rgb>> parse_background(const std::string& text) {
  if (text == "transparent" || text == "none") return std::nullopt;
  const auto color = parse_rgb(text);
  if (!color) return usage_error("--background expects RRGGBB or transparent, not " + in_quotes(text));
  return color;
}

BackgroundImage parse_image(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::array<double, 3> numbers{};
  if (colon == std::string::npos || !read_numbers(std::string_view(text).substr(colon + 1), numbers) ||
      !(numbers[2] > 0.0))
    return {.file = text};
  return {text.substr(0, colon), {numbers[0], numbers[1]}, numbers[2]};
}

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/text/ascii_text.h"

namespace mes {
namespace {

/// Length of the number at the beginning.
std::size_t number_length(std::string_view text) {
  std::size_t at = 0;
  const auto here = [&] { return at < text.size() ? text[at] : '\0'; };
  const auto skip_digits = [&] {
    const std::size_t begin = at;
    while (is_digit(here())) ++at;
    return at - begin;
  };
  if (here() == '-' || here() == '+') ++at;
  std::size_t digits = skip_digits();
  if (here() == '.') {
    ++at;
    digits += skip_digits();
  }
  if (digits == 0) return 0;
  const std::size_t mantissa = at;
  if (here() != 'e' && here() != 'E') return mantissa;
  ++at;
  if (here() == '-' || here() == '+') ++at;
  return skip_digits() == 0 ? mantissa : at;  // in "2em", the e belongs to the unit
}

}  // namespace

bool SvgText::any_number(double& value) {
  const std::size_t size = number_length({at_, end_});
  if (size == 0) return false;
  std::string_view token(at_, size);
  if (token.starts_with('+')) token.remove_prefix(1);
  double found = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), found);
  if (error == std::errc::invalid_argument) return false;
  // Numbers too near to zero are reported as out of range too; they stay zero.
  constexpr double kLargest = 1e300;
  const bool is_negative_power = token.find("e-") != token.npos || token.find("E-") != token.npos;
  if (error == std::errc::result_out_of_range && !is_negative_power) return false;
  if (error == std::errc::result_out_of_range) found = 0.0;
  if (!(std::abs(found) <= kLargest)) return false;
  at_ += size;
  value = found;
  return true;
}

std::optional<bool> SvgText::flag() {
  if (sign() != '0' && sign() != '1') return std::nullopt;
  return *at_++ == '1';
}

std::string_view SvgText::word() {
  const char* const begin = at_;
  while (at_ != end_ && is_letter(*at_)) ++at_;
  return {begin, at_};
}

double SvgViewport::reference(SvgAxis axis) const {
  if (axis == SvgAxis::x) return width;
  if (axis == SvgAxis::y) return height;
  return std::hypot(width, height) / std::numbers::sqrt2;
}

std::optional<SvgPaperLength> svg_paper_length(std::string_view text) {
  SvgText rest(trimmed(text));
  const auto value = rest.number();
  const std::string word = lower_case(rest.word());
  for (const std::string_view unit : {"mm", "cm", "in", "pt"})
    if (value && rest.is_at_end() && word == unit)
      return SvgPaperLength{*value, unit, *svg_length("1" + word, SvgAxis::both, {})};
  return std::nullopt;
}

std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgViewport& viewport) {
  using Unit = std::pair<std::string_view, double>;
  constexpr double kInch = 96.0;
  constexpr std::array<Unit, 11> kUnits{{{"", 1.0},
                                         {"px", 1.0},
                                         {"in", kInch},
                                         {"cm", kInch / 2.54},
                                         {"mm", kInch / 25.4},
                                         {"q", kInch / 101.6},
                                         {"pt", kInch / 72.0},
                                         {"pc", kInch / 6.0},
                                         {"em", 16.0},
                                         {"rem", 16.0},
                                         {"ex", 8.0}}};
  SvgText rest(trimmed(text));
  const auto value = rest.number();
  if (!value) return std::nullopt;
  if (rest.take('%'))
    return rest.is_at_end() ? std::optional(*value / 100.0 * viewport.reference(axis)) : std::nullopt;
  const std::string_view word = rest.word();
  if (!rest.is_at_end() || word.size() > 3) return std::nullopt;
  const auto unit = std::ranges::find(kUnits, std::string_view(lower_case(word)), &Unit::first);
  return unit == kUnits.end() ? std::nullopt : std::optional(*value * unit->second);
}

namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

/// One transform of a list, with its numbers.
std::optional<Affine> transform_named(std::string_view name, const std::array<double, 6>& n, std::size_t count) {
  if (name == "matrix" && count == 6) return Affine{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && (count == 1 || count == 2)) return Affine::translation(n[0], n[1]);
  if (name == "scale" && (count == 1 || count == 2)) return Affine::scaling(n[0], count == 1 ? n[0] : n[1]);
  if (name == "translateX" && count == 1) return Affine::translation(n[0], 0.0);
  if (name == "translateY" && count == 1) return Affine::translation(0.0, n[0]);
  if (name == "scaleX" && count == 1) return Affine::scaling(n[0], 1.0);
  if (name == "scaleY" && count == 1) return Affine::scaling(1.0, n[0]);
  if (name == "rotate" && count == 1) return Affine::rotation(n[0] * kRadian);
  if (name == "rotate" && count == 3)
    return Affine::translation(n[1], n[2]) * Affine::rotation(n[0] * kRadian) * Affine::translation(-n[1], -n[2]);
  if (name == "skewX" && count == 1) return Affine{1.0, 0.0, std::tan(n[0] * kRadian), 1.0, 0.0, 0.0};
  if (name == "skewY" && count == 1) return Affine{1.0, std::tan(n[0] * kRadian), 0.0, 1.0, 0.0, 0.0};
  return std::nullopt;
}

}  // namespace

namespace {

/// Value of a unit of lengths or angles in pixels or degrees; nothing for an unknown unit.
std::optional<double> unit_of_transform(std::string_view unit) {
  if (unit.empty() || unit == "px" || unit == "deg") return 1.0;
  if (unit == "rad") return 1.0 / kRadian;
  if (unit == "grad") return 0.9;
  if (unit == "turn") return 360.0;
  return std::nullopt;
}

}  // namespace

std::optional<Affine> svg_transform(std::string_view text) {
  Affine out;
  SvgText rest(text);
  if (trimmed(text) == "none") return out;
  for (rest.skip_comma(); !rest.is_at_end(); rest.skip_comma()) {
    const std::string_view name = rest.word();
    rest.skip_blanks();
    if (!rest.take('(')) return std::nullopt;
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    rest.skip_blanks();
    while (!rest.take(')')) {
      const auto value = rest.number();
      const auto unit = unit_of_transform(rest.word());
      if (!value || !unit || count == numbers.size()) return std::nullopt;
      numbers[count++] = *value * *unit;
      rest.skip_comma();
    }
    const auto map = transform_named(name, numbers, count);
    if (!map) return std::nullopt;
    out = out * *map;
  }
  return out;
}

std::optional<SvgViewBox> svg_view_box(std::string_view text) {
  SvgViewBox box{};
  SvgText rest(text);
  rest.skip_blanks();
  for (double& number : box) {
    const auto value = rest.number();
    if (!value) return std::nullopt;
    number = *value;
    rest.skip_comma();
  }
  if (!rest.is_at_end() || !(box[2] > 0.0) || !(box[3] > 0.0)) return std::nullopt;
  return box;
}

Affine svg_fit(const SvgViewBox& box, const SvgViewport& size, std::string_view preserve_aspect_ratio) {
  double x = size.width / box[2];
  double y = size.height / box[3];
  std::string_view align = trimmed(preserve_aspect_ratio);
  const bool covers = align.ends_with("slice");
  if (!align.starts_with("none")) x = y = covers ? std::max(x, y) : std::min(x, y);
  const double free_x = size.width - box[2] * x;
  const double free_y = size.height - box[3] * y;
  const double share_x = align.starts_with("xMin") ? 0.0 : align.starts_with("xMax") ? 1.0 : 0.5;
  const double share_y = align.contains("YMin") ? 0.0 : align.contains("YMax") ? 1.0 : 0.5;
  return Affine::translation(share_x * free_x, share_y * free_y) * Affine::scaling(x, y) *
         Affine::translation(-box[0], -box[1]);
}

std::optional<SvgLink> svg_link(std::string_view text) {
  text = trimmed(text);
  const std::size_t end = text.find(')');
  if (lower_case(text.substr(0, 4)) != "url(" || end == std::string_view::npos) return std::nullopt;
  SvgLink out{.rest = trimmed(text.substr(end + 1))};
  std::string_view inside = trimmed(text.substr(4, end - 4));
  if (inside.size() >= 2 && (inside.front() == '"' || inside.front() == '\'') && inside.back() == inside.front())
    inside = trimmed(inside.substr(1, inside.size() - 2));
  if (inside.starts_with('#')) out.id = inside.substr(1);
  return out;
}

std::optional<double> svg_share(std::string_view text) {
  SvgText rest(trimmed(text));
  auto value = rest.number();
  if (value && rest.take('%')) *value /= 100.0;
  return rest.is_at_end() ? value : std::nullopt;
}

}  // namespace mes

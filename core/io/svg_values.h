// SPDX-License-Identifier: GPL-3.0-or-later
// Values of attributes of SVG: numbers, lengths, transforms, viewports. Private to core/io.
//
// Source: SVG 2 (W3C Candidate Recommendation of 2018), and SVG 1.1 where it has more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/curves/affine.h"
#include "core/io/short_decimal.h"

namespace mes {

/// Reads numbers that may follow each other without anything between, as in "1-2.5.5".
class SvgText {
 public:
  explicit SvgText(std::string_view text) : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || (*at_ >= '\t' && *at_ <= '\r'))) ++at_;
  }
  /// Blanks with at most one comma among them.
  void skip_comma() {
    skip_blanks();
    if (take(',')) skip_blanks();
  }
  bool is_at_end() const { return at_ == end_; }
  char sign() const { return is_at_end() ? '\0' : *at_; }
  bool take(char wanted) {
    if (is_at_end() || *at_ != wanted) return false;
    ++at_;
    return true;
  }
  /// A finite number right here; nothing, and nothing is taken, where none is.
  std::optional<double> number() {
    double value = 0.0;
    return number(value) ? std::optional(value) : std::nullopt;
  }
  /// The same; false, and `value` as it was, where none is.
  bool number(double& value) {
    const std::size_t size = short_decimal({at_, end_}, value);
    if (size == 0) return any_number(value);
    at_ += size;
    return true;
  }
  /// One character, 0 or 1, for nothing need follow it.
  std::optional<bool> flag();
  /// Letters right here; may be empty.
  std::string_view word();
  std::string_view rest() const { return {at_, end_}; }
  /// No more than there are.
  void skip(std::size_t bytes) { at_ += bytes; }
  std::size_t place() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  bool any_number(double& value);

  const char* begin_;
  const char* at_;
  const char* end_;
};

/// What a percentage is of.
enum class SvgAxis : std::uint8_t { x, y, both };

/// The size in which lengths in percent are measured.
struct SvgViewport {
  double width = 0.0;
  double height = 0.0;
  double reference(SvgAxis axis) const;
};

/// In pixels of 1/96 inch; a letter "m" of a font has 16. Nothing for text that is not a length.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgViewport& viewport);

/// The product of a list of transforms, also as style sheets have them, with units; nothing for what is none.
std::optional<Affine> svg_transform(std::string_view text);

/// Least x and y, width and height.
using SvgViewBox = std::array<double, 4>;
/// Nothing for what is none or has no extent.
std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// From the coordinates of a view box to those of a viewport of this size, as `preserveAspectRatio` says.
Affine svg_fit(const SvgViewBox& box, const SvgViewport& size, std::string_view preserve_aspect_ratio);

/// What "url(#id)" refers to.
struct SvgLink {
  std::string_view id{};    ///< empty: nothing in this file
  std::string_view rest{};  ///< what follows
};
/// Nothing for text that begins otherwise.
std::optional<SvgLink> svg_link(std::string_view text);

/// A number, or a percentage of 1; nothing for what is none.
std::optional<double> svg_share(std::string_view text);

}  // namespace mes

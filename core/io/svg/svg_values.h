// SPDX-License-Identifier: GPL-3.0-or-later
// Values of SVG attributes: numbers, lengths, transforms, viewports. Private to core/io.
//
// Source: SVG 2 (W3C Candidate Recommendation of 2018), and SVG 1.1 where it has more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/curves/affine.h"
#include "core/io/text/short_decimal.h"

namespace mes {

/// Reads numbers, even without separators, as in "1-2.5.5".
class SvgText {
 public:
  explicit SvgText(std::string_view text) : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || (*at_ >= '\t' && *at_ <= '\r'))) ++at_;
  }
  /// Skips blanks with at most one comma among them.
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
  /// Takes a finite number at the cursor; nothing, and takes nothing, if there is none.
  std::optional<double> number() {
    double value = 0.0;
    return number(value) ? std::optional(value) : std::nullopt;
  }
  /// The same; false, and leaves `value` alone, if there is none.
  bool number(double& value) {
    const std::size_t size = short_decimal({at_, end_}, value);
    if (size == 0) return any_number(value);
    at_ += size;
    return true;
  }
  /// Takes one character, 0 or 1; no separator need follow it.
  std::optional<bool> flag();
  /// Takes letters at the cursor; may be empty.
  std::string_view word();
  std::string_view rest() const { return {at_, end_}; }
  /// Skips bytes; there must be that many.
  void skip(std::size_t bytes) { at_ += bytes; }
  std::size_t place() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  bool any_number(double& value);

  const char* begin_;
  const char* at_;
  const char* end_;
};

/// The reference length of a percentage.
enum class SvgAxis : std::uint8_t { x, y, both };

/// The size to which lengths in percent refer.
struct SvgViewport {
  double width = 0.0;
  double height = 0.0;
  double reference(SvgAxis axis) const;
};

/// A length in pixels of 1/96 inch; the font size is 16. Nothing for text that is not a length.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgViewport& viewport);

/// A length on paper, such as "84mm".
struct SvgPaperLength {
  double value = 0.0;
  std::string_view unit{};  ///< mm, cm, in or pt
  double pixels = 1.0;      ///< of 1/96 inch, in a unit
};
/// Nothing for another text.
std::optional<SvgPaperLength> svg_paper_length(std::string_view text);

/// The product of a list of transforms, also in style sheet form with units; nothing for invalid text.
std::optional<Affine> svg_transform(std::string_view text);

/// Least x and y, width and height.
using SvgViewBox = std::array<double, 4>;
/// Nothing for invalid text or a box without extent.
std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// Maps the coordinates of a view box to those of a viewport of this size, by `preserveAspectRatio`.
Affine svg_fit(const SvgViewBox& box, const SvgViewport& size, std::string_view preserve_aspect_ratio);

/// The target of "url(#id)".
struct SvgLink {
  std::string_view id{};    ///< empty: not in this file
  std::string_view rest{};  ///< the text after it
};
/// Nothing for any other text.
std::optional<SvgLink> svg_link(std::string_view text);

/// A number, or a percentage of 1; nothing for invalid text.
std::optional<double> svg_share(std::string_view text);

}  // namespace mes

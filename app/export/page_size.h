// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the size of a figure on paper.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// A size in points of 1/72 inch.
struct PageSize {
  double width = 0.0;
  std::optional<double> height;  ///< nothing: follows from the drawing
  double lettering = 1.0;        ///< factor for letters and lines; a slide is read from afar
};

/// A named size.
struct PagePreset {
  std::string_view name;
  std::string_view size;
  double lettering = 1.0;
};
std::span<const PagePreset> page_presets();

/// Parses "84mmx60mm", "84mm" or the name of a preset; units are mm, cm, in, pt and px (1/96 inch). Each side is from
/// 1 mm to 5080 mm. Error: `usage`, whose text continues the name of the option: "expects ...".
Expected<PageSize> parse_page_size(const std::string& text);

/// Parses a length with a unit, in points; nothing for any other text.
std::optional<double> parse_length(std::string_view text);

}  // namespace mes

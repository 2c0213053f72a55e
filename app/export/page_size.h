// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a figure on paper, from words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// In points of 1/72 inch.
struct PageSize {
  double width = 0.0;
  std::optional<double> height;  ///< none: what the drawing needs
};

/// A size that has a name.
struct PagePreset {
  std::string_view name;
  std::string_view size;
};
std::span<const PagePreset> page_presets();

/// "84mmx60mm", "84mm" or the name of a preset; units are mm, cm, in, pt and px (1/96 inch). Each side from 1 mm to
/// 5080 mm. Error: `usage`; its text goes on after the name of what was asked for: "expects ...".
Expected<PageSize> parse_page_size(const std::string& text);

/// A length with a unit, in points; nothing for anything else.
std::optional<double> parse_length(std::string_view text);

}  // namespace mes

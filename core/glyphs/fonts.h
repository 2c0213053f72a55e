// SPDX-License-Identifier: GPL-3.0-or-later
// The installed fonts, by name. Only TrueType and OpenType fonts with outlines count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// A font in a file.
struct FontFile {
  std::filesystem::path path{};
  std::uint32_t index = 0;  ///< in a collection; the upper 16 bits select a named instance of a variable font, from 1
  std::string name{};       ///< for messages
  friend bool operator==(const FontFile&, const FontFile&) = default;
};

/// Finds an installed font by name: a family ("DejaVu Sans"), with a style or other properties in fontconfig's syntax
/// ("DejaVu Sans:bold:italic"), the full name of a single font ("DejaVu Sans Bold") or its PostScript name; or "sans",
/// "serif", "monospace" for the fonts that the system prefers. A name with a slash is a file. Case does not matter.
/// Error: `usage` for a name that no font has; there is no substitution.
///
/// Cost: milliseconds; the first call reads the list of fonts. Any thread, one at a time.
Expected<FontFile> find_font(const std::string& name);

/// The name of a family in a style, as `find_font` accepts it, whatever characters the family name contains.
std::string font_name(const std::string& family, bool is_bold, bool is_italic);

/// The installed families, in alphabetical order.
std::vector<std::string> font_families();

}  // namespace mes

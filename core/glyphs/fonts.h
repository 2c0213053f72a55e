// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts of this machine, by name. TrueType and OpenType fonts with outlines count, and no others.
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
  std::uint32_t index = 0;  ///< of a collection; the upper 16 bits: which named instance of a variable font, from 1
  std::string name{};       ///< for messages
  friend bool operator==(const FontFile&, const FontFile&) = default;
};

/// The installed font of a name: that of a family ("DejaVu Sans"), with a style or other properties as fontconfig writes
/// them ("DejaVu Sans:bold:italic"), the full name of a single font ("DejaVu Sans Bold") or its PostScript name; or
/// "sans", "serif", "monospace" for whatever the system prefers. A name with a slash is that of a file. Upper and lower
/// case are alike. Error: `usage` for a name that no font has; nothing else is put in its place.
///
/// Cost: milliseconds; the first call reads the list of fonts. Any thread, one at a time.
Expected<FontFile> find_font(const std::string& name);

/// The name of a family in a style, as `find_font` takes it, whatever characters the family has in its name.
std::string font_name(const std::string& family, bool is_bold, bool is_italic);

/// The families that are installed, in the order of the alphabet.
std::vector<std::string> font_families();

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The font that comes with the program.
#pragma once

#include <filesystem>

#include "core/base/error.h"
#include "core/glyphs/fonts.h"

namespace mes {

/// The window's text font, read from the assets. Error: `bad_input` if it is missing.
Expected<FontFile> own_font(const std::filesystem::path& assets);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The font that comes with the program.
#pragma once

#include <filesystem>

#include "core/base/error.h"
#include "core/glyphs/fonts.h"

namespace mes {

/// The text font of the window, in the assets. Error: `bad_input` where it is missing.
Expected<FontFile> own_font(const std::filesystem::path& assets);

}  // namespace mes

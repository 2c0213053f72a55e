// SPDX-License-Identifier: GPL-3.0-or-later
// A window that shows only a text.
#pragma once

#include <string>

#include "imgui.h"

namespace mes {

/// The size of a window that shows this text, wrapped at the width, and nothing else.
ImVec2 note_size(const std::string& text, float width);
/// Draws the text in such a window.
void note(const std::string& text, float width);

}  // namespace mes

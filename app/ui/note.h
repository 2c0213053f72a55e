// SPDX-License-Identifier: GPL-3.0-or-later
// Text that a window shows alone.
#pragma once

#include <string>

#include "imgui.h"

namespace mes {

/// The size of a window that shows this text, wrapped at the width, and nothing else.
ImVec2 note_size(const std::string& text, float width);
/// The text in such a window.
void note(const std::string& text, float width);

}  // namespace mes

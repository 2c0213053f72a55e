// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts of figures as cairo fonts.
#pragma once

#include <cairo.h>

#include "render/image/text.h"

namespace mes::figure {

/// The face of a font, with the same glyph indices; null if FreeType cannot read the font. Kept until the program ends,
/// because cairo caches faces of painted letters; only one for each file: there are as many as fonts of the program.
/// Threads: any, several at the same time.
cairo_font_face_t* cairo_face_of(const render::Font& font);

}  // namespace mes::figure

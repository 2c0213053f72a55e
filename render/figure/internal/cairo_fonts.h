// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts of figures as cairo has them.
#pragma once

#include <cairo.h>

#include "render/text.h"

namespace mes::figure {

/// The face of a font, whose glyphs have the same indices; null if FreeType cannot read the font. It is kept until the
/// program ends, because cairo keeps faces of its own for letters painted, with those of the same file once only: there
/// are as many as fonts come with the program. Threads: any, several at the same time.
cairo_font_face_t* cairo_face_of(const render::Font& font);

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/cairo_fonts.h"

#include <cairo-ft.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <mutex>
#include <vector>

namespace mes::figure {
namespace {

struct KeptFace {
  render::Font font;  // FreeType reads its bytes on demand
  cairo_font_face_t* face = nullptr;
};

/// FreeType reads the font in place, without a copy.
cairo_font_face_t* new_face(const render::Font& font) {
  // Each face has its own library: several threads must not share a library.
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return nullptr;
  FT_Face face = nullptr;
  if (FT_New_Memory_Face(library, font.bytes().data(), static_cast<FT_Long>(font.bytes().size()), 0, &face) != 0) {
    FT_Done_FreeType(library);
    return nullptr;
  }
  return cairo_ft_font_face_create_for_ft_face(face, 0);
}

}  // namespace

cairo_font_face_t* cairo_face_of(const render::Font& font) {
  static std::mutex mutex;
  // Never destroyed: threads may still paint while the program ends.
  static auto& faces = *new std::vector<KeptFace>;
  const std::scoped_lock lock(mutex);
  for (const KeptFace& kept : faces)
    if (std::ranges::equal(kept.font.bytes(), font.bytes())) return kept.face;
  return faces.emplace_back(font, new_face(font)).face;
}

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
// Text in PDF: in the fonts of the figure, embedded in the file, or in Helvetica by name.
//
// Fonts are composite fonts (ISO 32000-1, 9.7) whose codes are glyph indices. A file embeds the outline tables of the
// fonts that occur, with the letters that occur.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "render/figure/figure.h"
#include "render/figure/internal/pdf_objects.h"

namespace mes::figure {

struct UsedGlyph {
  char32_t letter = 0;  ///< letter of the glyph
  int advance = 0;
};
/// Used glyphs by index.
using UsedGlyphs = std::map<int, UsedGlyph>;

class PdfFonts {
 public:
  /// Null: no fonts are embedded.
  explicit PdfFonts(std::shared_ptr<const Fonts> fonts) : fonts_(std::move(fonts)) {}

  /// The operators that select a font and show the text at the text matrix.
  std::string shown(const Text& text);

  /// The resource dictionary entry with all fonts of the texts shown so far; empty if there are none.
  std::string resources(PdfObjects& objects) const;

 private:
  std::shared_ptr<const Fonts> fonts_;
  // All fonts are members of one object, so the order of pointers is that of the members.
  std::map<const render::Font*, UsedGlyphs> used_;
  std::set<int> named_;  // styles of Helvetica
};

}  // namespace mes::figure

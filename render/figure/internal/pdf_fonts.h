// SPDX-License-Identifier: GPL-3.0-or-later
// Text in PDF: in the fonts of the figure, which the file then carries, or in Helvetica by name.
//
// Fonts are composite fonts (ISO 32000-1, 9.7) whose codes are the indices of their glyphs. A file carries the tables of
// outlines of fonts that occur, with the letters that occur.
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
  char32_t letter = 0;  ///< that it stands for
  int advance = 0;
};
/// By their indices.
using UsedGlyphs = std::map<int, UsedGlyph>;

class PdfFonts {
 public:
  /// Null: none is carried.
  explicit PdfFonts(std::shared_ptr<const Fonts> fonts) : fonts_(std::move(fonts)) {}

  /// The operators that choose a font and show the text where the text matrix says.
  std::string shown(const Text& text);

  /// The entry of a resource dictionary that has all fonts of what was shown before; empty for none.
  std::string resources(PdfObjects& objects) const;

 private:
  std::shared_ptr<const Fonts> fonts_;
  // Fonts lie in one object, so their order is that of its members.
  std::map<const render::Font*, UsedGlyphs> used_;
  std::set<int> named_;  // looks of Helvetica
};

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/lacking_letters.h"

#include <fmt/core.h>
#include <cstddef>
#include <cstdint>

namespace mes {

void LackingLetters::look_at(const render::Font& font, const std::string& text) {
  for (const render::Glyph& glyph : font.glyphs(text))
    if (glyph.index == 0) letters_.insert(glyph.letter);
}

void LackingLetters::look_at(const figure::Figure& figure) {
  if (!figure.fonts) return;
  const auto look = [&](const std::vector<figure::Text>& texts) {
    for (const figure::Text& text : texts) look_at(figure.fonts->of(text.is_bold, text.is_italic), text.text);
  };
  for (const figure::FigureLayer& layer : figure.layers) look(layer.texts);
  look(figure.legend.texts);
}

void LackingLetters::look_at(const PaperFonts& fonts, const PaperDrawing& drawing) {
  for (const PaperDrawing::Line& line : drawing.lines)
    look_at(fonts.of(line.face == Face::bold, line.face == Face::italic), line.text);
}

std::string LackingLetters::words() const {
  constexpr std::size_t kNamed = 3;
  std::string names;
  std::size_t named = 0;
  for (const char32_t letter : letters_) {
    if (named == kNamed) break;
    names += fmt::format("{}U+{:04X}", named == 0 ? "" : ", ", static_cast<std::uint32_t>(letter));
    ++named;
  }
  if (letters_.size() > named) names += fmt::format(" and {} more", letters_.size() - named);
  return letters_.empty() ? std::string() : fmt::format("the fonts have no letter {}: empty boxes are drawn", names);
}

}  // namespace mes

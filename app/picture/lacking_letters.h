// SPDX-License-Identifier: GPL-3.0-or-later
// Letters of texts that the program's fonts do not have.
//
// Smallest use:
//     LackingLetters lacking;
//     lacking.look_at(figure);
//     if (const std::string words = lacking.words(); !words.empty()) remarks.push_back(words);
#pragma once

#include <set>
#include <string>

#include "app/picture/paper_drawing.h"
#include "render/figure/figure.h"

namespace mes {

/// Cost: O(letters). Threads: any, with an object of its own.
class LackingLetters {
 public:
  /// Texts of all layers and of the legend; nothing in a figure without fonts.
  void look_at(const figure::Figure& figure);
  void look_at(const PaperFonts& fonts, const PaperDrawing& drawing);
  /// One line; empty: none is lacking.
  std::string words() const;

 private:
  void look_at(const render::Font& font, const std::string& text);
  std::set<char32_t> letters_;
};

}  // namespace mes

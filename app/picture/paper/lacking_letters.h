// SPDX-License-Identifier: GPL-3.0-or-later
// Finds letters of texts that the program's fonts lack.
//
// Smallest use:
//     LackingLetters lacking;
//     lacking.look_at(figure);
//     if (const std::string words = lacking.words(); !words.empty()) remarks.push_back(words);
#pragma once

#include <set>
#include <string>

#include "app/picture/paper/paper_drawing.h"
#include "render/figure/figure.h"

namespace mes {

/// Cost: O(letters). Threads: any, with an object of its own.
class LackingLetters {
 public:
  /// Examines the texts of all layers and of the legend; ignores a figure without fonts.
  void look_at(const figure::Figure& figure);
  void look_at(const PaperFonts& fonts, const PaperDrawing& drawing);
  /// A message of one line; empty if no letter is missing.
  std::string words() const;

 private:
  void look_at(const render::Font& font, const std::string& text);
  std::set<char32_t> letters_;
};

}  // namespace mes

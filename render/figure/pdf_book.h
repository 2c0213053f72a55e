// SPDX-License-Identifier: GPL-3.0-or-later
// Several pages in one file of PDF, each of figures side by side.
//
// What it guarantees beside what `render/figure/writers.h` says of all formats:
//  1. A layer is one optional content group for all pages it is on; viewers list those of the page that is seen.
//  2. Fonts are carried once, with the letters of all pages.
//  3. Pages that have a bookmark are in the outline, in their order.
//
// Smallest use:
//     PdfBook book({.title = "Lesson", .fonts = fonts});
//     book.add({.width = 960, .height = 540, .figures = {{&drawing, {300, 0}}, {&caption, {0, 0}}}, .bookmark = "One"});
//     const std::string bytes = std::move(book).file();
//
// Cost: that of the shapes; memory for the compressed pages. Threads: one at a time. Throws std::bad_alloc.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec2.h"
#include "render/figure/figure.h"

namespace mes::figure {

struct PlacedFigure {
  const Figure* figure = nullptr;
  Vec2 corner{};  ///< its upper left corner on the page, in points; what lies beyond its own page is cut
};

/// Lengths are in points.
struct Sheet {
  double width = 0.0;
  double height = 0.0;
  std::optional<Rgb> background{};      ///< below the figures and theirs
  std::vector<PlacedFigure> figures{};  ///< the first below
  std::string bookmark{};               ///< UTF-8; empty: none
};

struct BookInfo {
  std::string title{};                   ///< UTF-8; empty: none
  std::shared_ptr<const Fonts> fonts{};  ///< of the texts of all pages; none: Helvetica, by name
  std::string session{};                 ///< compressed (core/base/carried_session.h); empty: none
};

class PdfBook {
 public:
  explicit PdfBook(BookInfo info);
  ~PdfBook();
  PdfBook(PdfBook&& other) noexcept;
  PdfBook& operator=(PdfBook&& other) noexcept;

  /// The figures are not needed any more when it returns.
  void add(const Sheet& sheet);
  /// The bytes of the file; one page at least has been added.
  std::string file() &&;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace mes::figure

// SPDX-License-Identifier: GPL-3.0-or-later
// Several pages in one PDF file, each with figures side by side.
//
// Guarantees beside the guarantees of `render/figure/writers.h` for all formats:
//  1. A layer is one optional content group for all its pages; viewers list the groups of the visible page.
//  2. Fonts are embedded once, with the letters of all pages.
//  3. Pages with a bookmark are in the outline, in their order.
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
#include "core/base/geometry/vec2.h"
#include "render/figure/figure.h"

namespace mes::figure {

struct PlacedFigure {
  const Figure* figure = nullptr;
  Vec2 corner{};  ///< position of its upper left corner, in points; content beyond its own page is cut
};

/// Lengths are in points.
struct Sheet {
  double width = 0.0;
  double height = 0.0;
  std::optional<Rgb> background{};      ///< below all figures and their backgrounds
  std::vector<PlacedFigure> figures{};  ///< bottom first
  std::string bookmark{};               ///< UTF-8; empty: none
};

struct BookInfo {
  std::string title{};                   ///< UTF-8; empty: none
  std::shared_ptr<const Fonts> fonts{};  ///< fonts of all pages; none: Helvetica, by name
  std::string session{};                 ///< compressed (core/base/carried_session.h); empty: none
};

class PdfBook {
 public:
  explicit PdfBook(BookInfo info);
  ~PdfBook();
  PdfBook(PdfBook&& other) noexcept;
  PdfBook& operator=(PdfBook&& other) noexcept;

  /// Does not refer to the figures after it returns.
  void add(const Sheet& sheet);
  /// The bytes of the file; at least one page must have been added.
  std::string file() &&;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace mes::figure

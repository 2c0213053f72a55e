// SPDX-License-Identifier: GPL-3.0-or-later
// Text and plain shapes painted on a picture in memory: legends, captions.
//
// What it guarantees:
//  1. Same font, same text, same place: same pixels. No display and no OpenGL are needed.
//  2. What lies outside the picture is left out. Letters the font has not are drawn as its empty box; bytes that are
//  no
//     UTF-8 too.
//
// Smallest use:
//     const auto font = Font::read(file);
//     draw_text(image, *font, 14.0, 10.0, 24.0, palette::black, "medial axis");
//
// Cost: some microseconds a letter. Threads: const is safe.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "core/base/color.h"
#include "core/base/error.h"
#include "render/image.h"

namespace mes::render {

class Font {
 public:
  /// A TrueType or OpenType file that is trusted, such as one that comes with the program. Error: `bad_input`.
  static Expected<Font> read(const std::filesystem::path& file);
  ~Font();
  Font(Font&& other) noexcept;
  Font& operator=(Font&& other) noexcept;

 private:
  struct Data;
  explicit Font(std::unique_ptr<Data> data);
  std::unique_ptr<Data> data_;
  friend double text_width(const Font& font, double size_px, std::string_view text);
  friend void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color,
                        std::string_view text);
};

/// Pixels from the beginning of the first letter to the end of the last one, on one line.
double text_width(const Font& font, double size_px, std::string_view text);

/// Begins at x, with the foot of its letters at y, pixels from the upper left corner. `size_px` is the height of the
/// font as Dear ImGui counts it: from its ascent to its descent.
void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color, std::string_view text);

/// Edges that lie within a pixel cover it in part.
void fill_rectangle(Image& image, double left, double top, double width, double height, Rgb color,
                    double opacity = 1.0);

}  // namespace mes::render

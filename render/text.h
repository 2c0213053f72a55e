// SPDX-License-Identifier: GPL-3.0-or-later
// Paints text and rectangles on a picture in memory, for legends and captions.
//
// What it guarantees:
//  1. The same font, text and place yield the same pixels. It needs neither a display nor OpenGL.
//  2. Pixels outside the picture are left out. Letters that the font lacks, and bytes that are not UTF-8, are drawn as
//     the font's empty box.
//
// Smallest use:
//     const auto font = Font::read(file);
//     draw_text(image, *font, 14.0, 10.0, 24.0, palette::black, "medial axis");
//
// Cost: some microseconds a letter. Threads: several may use one font at the same time; a picture belongs to one.
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
  /// Reads a TrueType or OpenType file, which must be trusted, as those that come with the program are: the reader does
  /// not check it. Error: `bad_input`.
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

/// The width in pixels from the beginning of the first letter to the end of the last one, on one line.
double text_width(const Font& font, double size_px, std::string_view text);

/// Draws text that begins at x with its baseline at y, in pixels from the upper left corner. `size_px` is the height of
/// the font from its ascent to its descent, as in Dear ImGui.
void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color, std::string_view text);

/// Fills a rectangle; its edges cover pixels in part.
void fill_rectangle(Image& image, double left, double top, double width, double height, Rgb color,
                    double opacity = 1.0);

/// Paints a disk with a rim of one pixel that fades out. Parts outside the picture are dropped.
void fill_disk(Image& image, double x, double y, double radius, Rgb color);

}  // namespace mes::render

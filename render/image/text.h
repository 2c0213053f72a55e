// SPDX-License-Identifier: GPL-3.0-or-later
// Paints text and rectangles on a picture in memory, for legends and captions.
//
// Guarantees:
//  1. The same font, text and position yield the same pixels. It needs neither a display nor OpenGL.
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
#include <span>
#include <string_view>
#include <vector>

#include "core/base/color.h"
#include "core/base/error.h"
#include "render/image/image.h"

namespace mes::render {

/// A letter at its position on a line of text, in units of its font.
struct Glyph {
  int index = 0;        ///< index in the font; 0 is its empty box
  char32_t letter = 0;  ///< U+FFFD for bytes that are not UTF-8
  int x = 0;            ///< position of its origin, including kerning
  int advance = 0;
};

/// Copies share one file in memory.
class Font {
 public:
  /// Reads a TrueType or OpenType file, which must be trusted, like those of the program: the reader does not check it.
  /// Error: `bad_input`.
  static Expected<Font> read(const std::filesystem::path& file);

  /// The letters of a line, in order.
  std::vector<Glyph> glyphs(std::string_view text) const;
  int units_per_em() const;
  /// Units from ascent to descent, which is the size of text here.
  int units_per_size() const;

  /// The bytes of the whole file.
  std::span<const unsigned char> bytes() const;
  /// One table of the file, by its name of four letters; empty if it is missing.
  std::span<const unsigned char> table(std::string_view name) const;

 private:
  struct Data;
  explicit Font(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
  friend double text_width(const Font& font, double size_px, std::string_view text);
  friend struct GlyphPicture;
};

/// The coverage of each pixel by a glyph.
struct GlyphPicture {
  int left = 0;  ///< position of its upper left pixel, relative to the pixel of the origin; y down
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<unsigned char> cover;  ///< one byte a pixel, top row first

  /// The picture of a glyph by index; the origin is `part` beyond the upper left corner of its pixel, both in [0, 1).
  static GlyphPicture of(const Font& font, double size_px, int glyph, double part_x, double part_y);
};

/// The width in pixels from the beginning of the first letter to the end of the last one, on one line.
double text_width(const Font& font, double size_px, std::string_view text);

/// Draws text that begins at x with its baseline at y, in pixels from the upper left corner. `size_px` is the height of
/// the font from its ascent to its descent, as in Dear ImGui.
void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color, std::string_view text);

/// Fills a rectangle; its edges may cover pixels partially.
void fill_rectangle(Image& image, double left, double top, double width, double height, Rgb color,
                    double opacity = 1.0);

/// Paints a disk with a rim that fades over one pixel. Parts outside the picture are dropped.
void fill_disk(Image& image, double x, double y, double radius, Rgb color);

}  // namespace mes::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "render/image/internal/blend.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

namespace mes::render {
namespace {

constexpr int kNoLetter = 0xfffd;

/// Takes the next letter off the text. Bytes that are not UTF-8 are one letter, which no font has.
int next_letter(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t size = lead < 0x80 ? 1 : lead >> 5U == 6 ? 2 : lead >> 4U == 14 ? 3 : lead >> 3U == 30 ? 4 : 0;
  if (size == 0 || size > text.size()) {
    text.remove_prefix(1);
    return kNoLetter;
  }
  unsigned value = size == 1 ? lead : lead & (0x7fU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) >> 6U != 2) {
      text.remove_prefix(i);
      return kNoLetter;
    }
    value = value << 6U | (byte(i) & 0x3fU);
  }
  text.remove_prefix(size);
  return static_cast<int>(value);
}

/// The part of the interval from `at` to `at` + 1 that lies between two numbers.
double pixel_overlap(int at, double low, double high) {
  return std::clamp(std::min(high, at + 1.0) - std::max(low, static_cast<double>(at)), 0.0, 1.0);
}

}  // namespace

struct Font::Data {
  std::vector<unsigned char> bytes;
  stbtt_fontinfo info{};
};

Font::Font(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Expected<Font> Font::read(const std::filesystem::path& file) {
  const auto fail = [&](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file.string()});
  };
  std::ifstream stream(file, std::ios::binary);
  auto data = std::make_shared<Data>();
  data->bytes.assign(std::istreambuf_iterator<char>(stream), {});
  if (!stream || data->bytes.empty()) return fail("the font cannot be read");
  const int offset = stbtt_GetFontOffsetForIndex(data->bytes.data(), 0);
  if (offset < 0 || stbtt_InitFont(&data->info, data->bytes.data(), offset) == 0) return fail("this is not a font");
  return Font(std::move(data));
}

std::vector<Glyph> Font::glyphs(std::string_view text) const {
  const stbtt_fontinfo& info = data_->info;
  std::vector<Glyph> out;
  int x = 0;
  while (!text.empty()) {
    const int letter = next_letter(text);
    const int index = stbtt_FindGlyphIndex(&info, letter);
    int advance = 0;
    stbtt_GetGlyphHMetrics(&info, index, &advance, nullptr);
    if (!out.empty()) x += stbtt_GetGlyphKernAdvance(&info, out.back().index, index);
    out.push_back({index, static_cast<char32_t>(letter), x, advance});
    x += advance;
  }
  return out;
}

int Font::units_per_em() const {
  return static_cast<int>(std::lround(1.0F / stbtt_ScaleForMappingEmToPixels(&data_->info, 1.0F)));
}

int Font::units_per_size() const {
  int ascent = 0;
  int descent = 0;
  stbtt_GetFontVMetrics(&data_->info, &ascent, &descent, nullptr);
  return ascent - descent;
}

std::span<const unsigned char> Font::bytes() const {
  return data_->bytes;
}

std::span<const unsigned char> Font::table(std::string_view name) const {
  // OpenType specification, "Table directory": number of tables, then name, checksum, offset and length of each.
  constexpr std::size_t kHead = 12;
  constexpr std::size_t kEntry = 16;
  const std::span<const unsigned char> file = bytes();
  const auto number = [&](std::size_t at, std::size_t size) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < size; ++i) out = out << 8U | file[at + i];
    return out;
  };
  const auto start = static_cast<std::size_t>(data_->info.fontstart);
  const std::size_t count = file.size() >= start + kHead ? number(start + 4, 2) : 0;
  for (std::size_t at = start + kHead; at < start + kHead + kEntry * count && at + kEntry <= file.size();
       at += kEntry) {
    if (!std::equal(name.begin(), name.end(), file.begin() + static_cast<std::ptrdiff_t>(at))) continue;
    const std::size_t offset = number(at + 8, 4);
    const std::size_t length = number(at + 12, 4);
    return offset <= file.size() && length <= file.size() - offset ? file.subspan(offset, length) : file.first(0);
  }
  return {};
}

double text_width(const Font& font, double size_px, std::string_view text) {
  const float scale = stbtt_ScaleForPixelHeight(&font.data_->info, static_cast<float>(size_px));
  const std::vector<Glyph> glyphs = font.glyphs(text);
  return glyphs.empty() ? 0.0 : static_cast<double>(scale) * (glyphs.back().x + glyphs.back().advance);
}

GlyphPicture GlyphPicture::of(const Font& font, double size_px, int glyph, double part_x, double part_y) {
  const stbtt_fontinfo& info = font.data_->info;
  const float scale = stbtt_ScaleForPixelHeight(&info, static_cast<float>(size_px));
  const auto x = static_cast<float>(part_x);
  const auto y = static_cast<float>(part_y);
  GlyphPicture out;
  int right = 0;
  int bottom = 0;
  stbtt_GetGlyphBitmapBoxSubpixel(&info, glyph, scale, scale, x, y, &out.left, &out.top, &right, &bottom);
  out.width = std::max(0, right - out.left);
  out.height = std::max(0, bottom - out.top);
  if (out.width == 0 || out.height == 0) return out;
  out.cover.assign(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), 0);
  stbtt_MakeGlyphBitmapSubpixel(&info, out.cover.data(), out.width, out.height, out.width, scale, scale, x, y, glyph);
  return out;
}

void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color, std::string_view text) {
  const auto unit = static_cast<double>(static_cast<float>(size_px) / static_cast<float>(font.units_per_size()));
  const double start = x;
  const double base = std::floor(y);
  for (const Glyph& glyph : font.glyphs(text)) {
    x = start + unit * glyph.x;
    const double left = std::floor(x);
    const GlyphPicture picture = GlyphPicture::of(font, size_px, glyph.index, x - left, y - base);
    auto cover = picture.cover.begin();
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column, ++cover) {
        const int to_x = static_cast<int>(left) + picture.left + column;
        const int to_y = static_cast<int>(base) + picture.top + row;
        if (to_x < 0 || to_y < 0 || to_x >= image.width || to_y >= image.height) continue;
        blend(image, to_x, to_y, color, *cover / 255.0);
      }
    }
  }
}

void fill_rectangle(Image& image, double left, double top, double width, double height, Rgb color, double opacity) {
  const double right = std::min(left + width, static_cast<double>(image.width));
  const double bottom = std::min(top + height, static_cast<double>(image.height));
  left = std::max(left, 0.0);
  top = std::max(top, 0.0);
  for (int y = static_cast<int>(top); y < bottom; ++y)
    for (int x = static_cast<int>(left); x < right; ++x)
      blend(image, x, y, color, opacity * pixel_overlap(x, left, right) * pixel_overlap(y, top, bottom));
}

void fill_disk(Image& image, double x, double y, double radius, Rgb color) {
  const auto from = [](double at, int size) { return std::clamp(static_cast<int>(std::floor(at)), 0, size); };
  const int right = from(x + radius + 1.0, image.width);
  const int bottom = from(y + radius + 1.0, image.height);
  for (int row = from(y - radius, image.height); row < bottom; ++row)
    for (int column = from(x - radius, image.width); column < right; ++column) {
      const double distance = std::hypot(column + 0.5 - x, row + 0.5 - y);
      blend(image, column, row, color, std::clamp(radius + 0.5 - distance, 0.0, 1.0));
    }
}

}  // namespace mes::render

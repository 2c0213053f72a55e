// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

namespace mes::render {
namespace {

constexpr int kNoLetter = 0xfffd;

/// Removes the next letter from the text and returns it. Bytes that are not UTF-8 are one letter, which no font has.
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

/// Paints `color` over a pixel of a picture whose alpha is not multiplied in.
void blend(Image& image, int x, int y, Rgb color, double alpha) {
  std::uint8_t* const at = &image.rgba[image.offset(x, y)];
  const double below = at[3] / 255.0 * (1.0 - alpha);
  const double total = alpha + below;
  if (total <= 0.0) return;
  const auto mix = [&](std::uint8_t under, std::uint8_t over) {
    return static_cast<std::uint8_t>(std::lround((over * alpha + under * below) / total));
  };
  at[0] = mix(at[0], color.r);
  at[1] = mix(at[1], color.g);
  at[2] = mix(at[2], color.b);
  at[3] = static_cast<std::uint8_t>(std::lround(255.0 * total));
}

/// The part of the interval from `at` to `at` + 1 that lies between two numbers.
double overlap(int at, double low, double high) {
  return std::clamp(std::min(high, at + 1.0) - std::max(low, static_cast<double>(at)), 0.0, 1.0);
}

}  // namespace

struct Font::Data {
  std::vector<unsigned char> bytes;
  stbtt_fontinfo info{};
};

Font::Font(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Font::~Font() = default;
Font::Font(Font&& other) noexcept = default;
Font& Font::operator=(Font&& other) noexcept = default;

Expected<Font> Font::read(const std::filesystem::path& file) {
  const auto fail = [&](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file.string()});
  };
  std::ifstream stream(file, std::ios::binary);
  auto data = std::make_unique<Data>();
  data->bytes.assign(std::istreambuf_iterator<char>(stream), {});
  if (!stream || data->bytes.empty()) return fail("the font cannot be read");
  const int offset = stbtt_GetFontOffsetForIndex(data->bytes.data(), 0);
  if (offset < 0 || stbtt_InitFont(&data->info, data->bytes.data(), offset) == 0) return fail("this is not a font");
  return Font(std::move(data));
}

double text_width(const Font& font, double size_px, std::string_view text) {
  const stbtt_fontinfo& info = font.data_->info;
  const auto scale = static_cast<double>(stbtt_ScaleForPixelHeight(&info, static_cast<float>(size_px)));
  double width = 0.0;
  int before = 0;
  while (!text.empty()) {
    const int letter = next_letter(text);
    int advance = 0;
    stbtt_GetCodepointHMetrics(&info, letter, &advance, nullptr);
    width += scale * (advance + (before == 0 ? 0 : stbtt_GetCodepointKernAdvance(&info, before, letter)));
    before = letter;
  }
  return width;
}

void draw_text(Image& image, const Font& font, double size_px, double x, double y, Rgb color, std::string_view text) {
  const stbtt_fontinfo& info = font.data_->info;
  const float scale = stbtt_ScaleForPixelHeight(&info, static_cast<float>(size_px));
  std::vector<unsigned char> cover;
  int before = 0;
  while (!text.empty()) {
    const int letter = next_letter(text);
    if (before != 0) x += static_cast<double>(scale) * stbtt_GetCodepointKernAdvance(&info, before, letter);
    before = letter;
    const double left = std::floor(x);
    const double base = std::floor(y);
    const auto part_x = static_cast<float>(x - left);
    const auto part_y = static_cast<float>(y - base);
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    stbtt_GetCodepointBitmapBoxSubpixel(&info, letter, scale, scale, part_x, part_y, &x0, &y0, &x1, &y1);
    const int width = x1 - x0;
    const int height = y1 - y0;
    if (width > 0 && height > 0) {
      cover.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
      stbtt_MakeCodepointBitmapSubpixel(&info, cover.data(), width, height, width, scale, scale, part_x, part_y,
                                        letter);
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          const int to_x = static_cast<int>(left) + x0 + column;
          const int to_y = static_cast<int>(base) + y0 + row;
          if (to_x < 0 || to_y < 0 || to_x >= image.width || to_y >= image.height) continue;
          const std::size_t at =
              static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
          blend(image, to_x, to_y, color, cover[at] / 255.0);
        }
      }
    }
    int advance = 0;
    stbtt_GetCodepointHMetrics(&info, letter, &advance, nullptr);
    x += static_cast<double>(scale) * advance;
  }
}

void fill_rectangle(Image& image, double left, double top, double width, double height, Rgb color, double opacity) {
  const double right = std::min(left + width, static_cast<double>(image.width));
  const double bottom = std::min(top + height, static_cast<double>(image.height));
  left = std::max(left, 0.0);
  top = std::max(top, 0.0);
  for (int y = static_cast<int>(top); y < bottom; ++y)
    for (int x = static_cast<int>(left); x < right; ++x)
      blend(image, x, y, color, opacity * overlap(x, left, right) * overlap(y, top, bottom));
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

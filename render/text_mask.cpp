// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/text_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mes::render {
namespace {

// Letters are positioned in quarters of a pixel.
constexpr int kQuarters = 4;
// Farther letters do not reach into the view, and pixel numbers would overflow integers.
constexpr double kFarPx = 1e6;

}  // namespace

void TextMask::forget() {
  if (mask_ != TextureId{}) device_.destroy_texture(mask_);
  mask_ = {};
  texts_.reset();
  rows_ = {};
  parts_.clear();
  painted_ = {};
}

// Clears only the pixels with letters.
void TextMask::clear() {
  const auto width = static_cast<std::size_t>(camera_.width());
  for (int y = painted_.top; y < painted_.bottom; ++y) {
    const auto row = static_cast<std::size_t>(camera_.height() - 1 - y) * width;
    std::fill_n(rows_.begin() + static_cast<std::ptrdiff_t>(row) + painted_.left, painted_.right - painted_.left,
                std::uint16_t{0});
  }
  painted_ = {camera_.width(), camera_.height(), 0, 0};
}

void TextMask::show(const std::shared_ptr<const LayerTexts>& texts, const Camera& camera, double content_scale) {
  if (mask_ != TextureId{} && texts == texts_ && camera == camera_ && content_scale == scale_) return;
  try {
    const bool has_room =
        mask_ != TextureId{} && camera.width() == camera_.width() && camera.height() == camera_.height();
    if (!has_room) forget();
    camera_ = camera;
    if (!has_room) {
      rows_.assign(static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height()), 0);
      mask_ = device_.create_mask(camera.width(), camera.height());
    }
    clear();
    texts_ = texts;
    scale_ = content_scale;
    parts_.clear();
    const double size = texts->size * content_scale;
    if (!font_ || texts->font->bytes().data() != font_->bytes().data() || size != size_px_) {
      lines_.clear();
      pictures_.clear();
      font_ = texts->font;
      size_px_ = size;
    }
    for (const PlacedText& each : texts->texts) {
      const Vec2 start = camera.to_screen(each.at) + content_scale * texts->shift;
      // NaN fails this test, too.
      if (std::abs(start.x) < kFarPx && std::abs(start.y) < kFarPx) paint(start, glyphs_of(each.text));
    }
    if (painted_.left >= painted_.right || painted_.top >= painted_.bottom) {
      painted_ = {};
      return;
    }
    const int first = camera.height() - painted_.bottom;
    const auto width = static_cast<std::size_t>(camera.width());
    device_.update_mask(mask_, first,
                        std::span<const std::uint16_t>(rows_).subspan(
                            width * static_cast<std::size_t>(first),
                            width * static_cast<std::size_t>(painted_.bottom - painted_.top)));
    parts_.push_back({painted_.left, first, painted_.right - painted_.left, painted_.bottom - painted_.top});
  } catch (...) {
    forget();
    throw;
  }
}

void TextMask::paint(Vec2 start, const std::vector<Glyph>& glyphs) {
  const double unit = size_px_ / font_->units_per_size();
  const auto quarters = [](double x) { return static_cast<int>(std::floor(kQuarters * x + 0.5)); };
  const auto whole = [](int quarter) {
    return quarter >= 0 ? quarter / kQuarters : -((kQuarters - 1 - quarter) / kQuarters);
  };
  const int y = quarters(start.y);
  for (const Glyph& glyph : glyphs) {
    const int x = quarters(start.x + unit * glyph.x);
    paint(picture_of(glyph.index, x - kQuarters * whole(x), y - kQuarters * whole(y)), whole(x), whole(y));
  }
}

void TextMask::paint(const GlyphPicture& picture, int left, int top) {
  left += picture.left;
  top += picture.top;
  const int from_x = std::max(left, 0);
  const int from_y = std::max(top, 0);
  const int end_x = std::min(left + picture.width, camera_.width());
  const int end_y = std::min(top + picture.height, camera_.height());
  if (from_x >= end_x || from_y >= end_y) return;
  painted_ = {std::min(painted_.left, from_x), std::min(painted_.top, from_y), std::max(painted_.right, end_x),
              std::max(painted_.bottom, end_y)};
  constexpr unsigned kFull = std::numeric_limits<std::uint16_t>::max();
  constexpr unsigned kStep = kFull / 255U;
  for (int y = from_y; y < end_y; ++y) {
    const unsigned char* cover =
        &picture.cover[static_cast<std::size_t>((y - top) * picture.width + (from_x - left))];
    std::uint16_t* row =
        &rows_[static_cast<std::size_t>(camera_.height() - 1 - y) * static_cast<std::size_t>(camera_.width()) +
               static_cast<std::size_t>(from_x)];
    for (int x = from_x; x < end_x; ++x, ++row, ++cover)
      *row = static_cast<std::uint16_t>(std::min(kFull, *row + kStep * *cover));
  }
}

const std::vector<Glyph>& TextMask::glyphs_of(const std::string& text) {
  constexpr std::size_t kMost = 50'000;
  if (lines_.size() >= kMost) lines_.clear();
  const auto [found, is_new] = lines_.try_emplace(text);
  if (is_new) found->second = font_->glyphs(text);
  return found->second;
}

const GlyphPicture& TextMask::picture_of(int glyph, int quarter_x, int quarter_y) {
  const std::uint64_t key =
      (static_cast<std::uint64_t>(glyph) * kQuarters + static_cast<std::uint64_t>(quarter_x)) * kQuarters +
      static_cast<std::uint64_t>(quarter_y);
  const auto [found, is_new] = pictures_.try_emplace(key);
  if (is_new) {
    constexpr double kPart = 1.0 / kQuarters;
    found->second = GlyphPicture::of(*font_, size_px_, glyph, kPart * quarter_x, kPart * quarter_y);
  }
  return found->second;
}

}  // namespace mes::render

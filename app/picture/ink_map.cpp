// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ink_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace mes {
namespace {

constexpr int kCell = 4;  // pixels

/// A pixel without ink, in the channels that count.
struct InkPaper {
  std::array<int, 4> color{};
  std::size_t channels = 0;
};

InkPaper paper_of(const std::optional<Rgb>& canvas) {
  // The alpha of a window is anything.
  if (canvas) return {{canvas->r, canvas->g, canvas->b, 0}, 3};
  return {{}, 4};
}

bool is_ink(const std::uint8_t* pixel, const InkPaper& paper) {
  constexpr int kVisible = 8;  // difference of a channel
  for (std::size_t i = 0; i < paper.channels; ++i)
    if (std::abs(int{pixel[i]} - paper.color[i]) > kVisible) return true;
  return false;
}

}  // namespace

InkMap::InkMap(const render::RawImage& picture, const render::Camera& camera, const std::optional<Rgb>& canvas)
    : camera_(camera),
      columns_((picture.width + kCell - 1) / kCell),
      rows_((picture.height + kCell - 1) / kCell),
      sums_((static_cast<std::size_t>(columns_) + 1) * (static_cast<std::size_t>(rows_) + 1)) {
  const InkPaper paper = paper_of(canvas);
  const auto stride = static_cast<std::size_t>(columns_) + 1;
  const std::uint8_t* pixel = picture.rgba.data();
  // Row 0 of the picture is the lowest.
  for (int y = picture.height - 1; y >= 0; --y) {
    std::uint32_t* const cells = sums_.data() + (static_cast<std::size_t>(y / kCell) + 1) * stride + 1;
    for (int x = 0; x < picture.width; ++x, pixel += 4)
      if (is_ink(pixel, paper)) cells[x / kCell] = 1;
  }
  for (std::size_t row = 1; row <= static_cast<std::size_t>(rows_); ++row)
    for (std::size_t column = 1; column < stride; ++column) {
      const std::size_t at = row * stride + column;
      sums_[at] += sums_[at - 1] + sums_[at - stride] - sums_[at - stride - 1];
    }
}

bool InkMap::has_ink(const Box2& box) const {
  const auto cell = [](double px, int most) {
    return static_cast<std::size_t>(std::clamp(px / kCell, 0.0, static_cast<double>(most)));
  };
  const std::size_t left = cell(std::floor(box.low.x), columns_);
  const std::size_t top = cell(std::floor(box.low.y), rows_);
  const std::size_t right = cell(std::ceil(box.high.x) + kCell - 1, columns_);
  const std::size_t bottom = cell(std::ceil(box.high.y) + kCell - 1, rows_);
  if (right <= left || bottom <= top) return false;
  const std::size_t stride = static_cast<std::size_t>(columns_) + 1;
  return sums_[bottom * stride + right] - sums_[bottom * stride + left] - sums_[top * stride + right] +
             sums_[top * stride + left] !=
         0;
}

std::size_t InkMap::parts_below(const Box2& box, const render::Camera& now) const {
  if (sums_.empty() || box.is_empty()) return 0;
  constexpr int kParts = 64;
  const double shape = box.width() / std::max(1.0, box.height());
  const int columns = std::clamp(static_cast<int>(std::lround(std::sqrt(kParts * shape))), 1, kParts);
  const int rows = kParts / columns;
  const Vec2 size{box.width() / columns, box.height() / rows};
  const auto then = [&](Vec2 px) { return now == camera_ ? px : camera_.to_screen(now.to_world(px)); };
  std::size_t out = 0;
  for (int i = 0; i < columns * rows; ++i) {
    const Vec2 low = box.low + Vec2{(i % columns) * size.x, (i / columns) * size.y};
    out += has_ink({then(low), then(low + size)}) ? 1U : 0U;
  }
  return out;
}

}  // namespace mes

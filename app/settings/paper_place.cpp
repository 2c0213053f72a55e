// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/paper_place.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

// In the order of `PaperCorner`.
constexpr std::array<std::string_view, 4> kCorners{"top-left", "top-right", "bottom-left", "bottom-right"};

bool is_right(PaperCorner corner) {
  return corner == PaperCorner::top_right || corner == PaperCorner::bottom_right;
}
bool is_bottom(PaperCorner corner) {
  return corner == PaperCorner::bottom_left || corner == PaperCorner::bottom_right;
}

PaperCorner corner_of(bool right, bool bottom) {
  if (bottom) return right ? PaperCorner::bottom_right : PaperCorner::bottom_left;
  return right ? PaperCorner::top_right : PaperCorner::top_left;
}

/// The position along one side of the room.
double placed(double offset, double size, double low, double high, bool from_high) {
  const double at = from_high ? high - offset - size : low + offset;
  return std::max(low, std::min(at, high - size));
}

/// Converts logical pixels to millimetres.
double offset_of(double px, double reach) {
  if (std::abs(px - kUsualMarginPx) <= reach) px = kUsualMarginPx;
  return std::clamp(px * kMillimetersPerPixel, 0.0, kMostPlaceMm);
}

std::optional<double> length_of(std::string_view text) {
  const auto value = parse_number(text);
  if (!value || *value < 0.0 || *value > kMostPlaceMm) return std::nullopt;
  return *value;
}

}  // namespace

Vec2 placed(const PaperPlace& place, Vec2 size, const Box2& room) {
  const Vec2 px = (1.0 / kMillimetersPerPixel) * place.mm;
  return {placed(px.x, size.x, room.low.x, room.high.x, is_right(place.corner)),
          placed(px.y, size.y, room.low.y, room.high.y, is_bottom(place.corner))};
}

PaperPlace place_of(Vec2 upper_left, Vec2 size, const Box2& room, double reach) {
  const Vec2 lower_right = upper_left + size;
  const Vec2 from_low = upper_left - room.low;
  const Vec2 from_high = room.high - lower_right;
  const bool right = from_high.x < from_low.x;
  const bool bottom = from_high.y < from_low.y;
  return {corner_of(right, bottom),
          {offset_of(right ? from_high.x : from_low.x, reach), offset_of(bottom ? from_high.y : from_low.y, reach)}};
}

std::string to_text(const PaperPlace& place) {
  const std::string_view corner = kCorners[static_cast<std::size_t>(place.corner)];
  if (place.mm == PaperPlace{}.mm) return std::string(corner);
  return fmt::format("{}:{},{}", corner, place.mm.x, place.mm.y);
}

std::optional<PaperPlace> parse_place(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto corner = std::ranges::find(kCorners, text.substr(0, colon));
  if (corner == kCorners.end()) return std::nullopt;
  PaperPlace out{.corner = static_cast<PaperCorner>(corner - kCorners.begin())};
  if (colon == text.size()) return out;
  const std::string_view lengths = text.substr(colon + 1);
  const std::size_t comma = lengths.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = length_of(lengths.substr(0, comma));
  const auto y = length_of(lengths.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  out.mm = {*x, *y};
  return out;
}

std::span<const std::string_view> place_corners() {
  return kCorners;
}

}  // namespace mes

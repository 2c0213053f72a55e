// SPDX-License-Identifier: GPL-3.0-or-later
// Hilbert curve keys: points that are close along the curve are close in the plane.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/rng.h"
#include "core/base/slot.h"

namespace mes {

/// Position of the cell (x, y), 16 bits each, along the Hilbert curve of order 16.
inline std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  for (std::uint32_t bit = 1U << 15U; bit != 0; bit >>= 1U) {
    const std::uint32_t rx = (x & bit) != 0 ? 1U : 0U;
    const std::uint32_t ry = (y & bit) != 0 ? 1U : 0U;
    key = (key << 2U) | ((3U * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

/// Maps points of a box to Hilbert keys.
class HilbertGrid {
 public:
  HilbertGrid() = default;
  explicit HilbertGrid(const Box2& box) : low_(box.low) {
    // Halved before subtracting, so that boxes as wide as the doubles do not overflow.
    const double half = std::max(0.5 * box.high.x - 0.5 * box.low.x, 0.5 * box.high.y - 0.5 * box.low.y);
    if (half > 1e-290) inverse_half_ = 32767.5 / half;
  }
  std::uint32_t key(Vec2 p) const { return hilbert_key(cell(p.x, low_.x), cell(p.y, low_.y)); }

 private:
  std::uint32_t cell(double value, double low) const {
    const double t = (0.5 * value - 0.5 * low) * inverse_half_;
    return t > 0.0 ? static_cast<std::uint32_t>(std::min(t, 65535.0)) : 0U;
  }
  Vec2 low_{};
  double inverse_half_ = 0.0;
};

/// A row and its position along the curve.
template <class Row>
struct Keyed {
  std::uint64_t key = 0;
  Row slot{};
};

/// Sorts stably by the low `bits` bits of the key. O(n * bits / 11).
template <class Row>
void radix_sort(std::vector<Keyed<Row>>& items, std::vector<Keyed<Row>>& scratch, unsigned bits) {
  constexpr unsigned kDigit = 11;
  scratch.resize(items.size());
  for (unsigned shift = 0; shift < bits; shift += kDigit) {
    std::vector<std::uint32_t> start((1U << kDigit) + 1U, 0);
    for (const Keyed<Row>& item : items) ++start[((item.key >> shift) & ((1U << kDigit) - 1U)) + 1U];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const Keyed<Row>& item : items) scratch[start[(item.key >> shift) & ((1U << kDigit) - 1U)]++] = item;
    items.swap(scratch);
  }
}

/// The rows below `count` in random rounds, each about twice as long as all rounds before; rows ascend within a round.
/// Inserting in this order what is sorted along a curve avoids vertices of huge degree on the way, and finds each point
/// from the one before. Always the same for the same count.
/// Source: Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003.
template <class Row>
std::vector<Row> in_rounds(std::size_t count) {
  constexpr unsigned kRounds = 31;
  std::vector<std::uint8_t> round(count);
  std::vector<std::size_t> start(kRounds + 2, 0);
  Rng coins(1);
  for (std::uint8_t& r : round) {
    const auto heads = static_cast<unsigned>(std::countl_zero(coins.next() | 1U));
    r = static_cast<std::uint8_t>(kRounds - std::min(heads, kRounds));
    ++start[r + 1U];
  }
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Row> order(count);
  for (std::size_t i = 0; i < count; ++i) order[start[round[i]]++] = Row(i);
  return order;
}

/// Number of positions before the first that does not lie on one line with all before it. `position(i)` returns position
/// i of `count`, and `orientation` decides about three of them.
template <class Position, class Orientation>
std::size_t count_on_line(std::size_t count, Position position, Orientation orientation) {
  std::size_t second = 1;
  while (second < count && position(second) == position(0)) ++second;
  std::size_t out = second;
  while (out < count && orientation(position(0), position(second), position(out)) == 0) ++out;
  return std::min(out, count);
}

/// While all that it holds lies on a line, a triangulation of CGAL looks through it for each new point, unless that lies
/// beyond the ends. So if all of the order lies on a line, it becomes that along the line, and one off the line comes
/// first if many on the line would come before it. `less` compares positions along any line.
template <class Row, class Position, class Orientation, class Less>
void leave_line_early(std::vector<Row>& order, Position position, Orientation orientation, Less less) {
  const std::size_t on_line = count_on_line(
      order.size(), [&](std::size_t i) { return position(order[i]); }, orientation);
  constexpr std::size_t kFew = 64;
  if (on_line == order.size()) {
    std::ranges::stable_sort(order, less, position);
  } else if (on_line > kFew) {
    const auto corner = order.begin() + static_cast<std::ptrdiff_t>(on_line);
    std::rotate(order.begin(), corner, corner + 1);
  }
}

}  // namespace mes

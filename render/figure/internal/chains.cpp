// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/chains.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <utility>

namespace mes::figure {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// One end of a segment; the ends of segment i have the numbers 2 i and 2 i + 1.
struct End {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::uint32_t number = 0;
  bool is_at(const End& other) const { return x == other.x && y == other.y; }
  friend auto operator<=>(const End&, const End&) = default;
};

/// Finds the segments that meet at a point.
class Junctions {
 public:
  Junctions(std::span<const Shape> segments, const Grid& grid) : first_(2 * segments.size()) {
    for (const Shape& segment : segments) {
      for (const Vec2 p : {segment.p[0], segment.p[1]})
        ends_.push_back({grid.index(p.x), grid.index(p.y), static_cast<std::uint32_t>(ends_.size())});
    }
    std::ranges::sort(ends_);
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
      first_[ends_[i].number] = i > 0 && ends_[i].is_at(ends_[i - 1]) ? first_[ends_[i - 1].number] : i;
    next_.resize(ends_.size());
    for (std::uint32_t i = 0; i < next_.size(); ++i) next_[i] = i;
  }

  /// An end of an unused segment at the same point; each point is scanned only once in all.
  std::uint32_t unused_at(std::uint32_t end, const std::vector<char>& is_used) {
    const std::uint32_t begin = first_[end];
    std::uint32_t& at = next_[begin];
    while (at < ends_.size() && ends_[at].is_at(ends_[begin])) {
      if (is_used[ends_[at].number / 2] == 0) return ends_[at].number;
      ++at;
    }
    return kNone;
  }

 private:
  std::vector<End> ends_;             // sorted by position
  std::vector<std::uint32_t> first_;  // by end number: index in `ends_` of the first end at the same position
  std::vector<std::uint32_t> next_;   // by such an index: where to continue the scan
};

}  // namespace

void chain_segments(std::vector<Shape>& shapes, const Grid& grid) {
  const auto others =
      std::ranges::stable_partition(shapes, [](const Shape& shape) { return is_chained(shape.kind); });
  const std::span<const Shape> segments(shapes.begin(), others.begin());
  if (segments.size() < 2) return;
  Junctions junctions(segments, grid);
  std::vector<char> is_used(segments.size(), 0);
  std::vector<Shape> out;
  out.reserve(shapes.size());
  std::vector<Shape> before;
  const auto follow = [&](std::uint32_t end, std::vector<Shape>& to) {
    while ((end = junctions.unused_at(end, is_used)) != kNone) {
      const std::uint32_t segment = end / 2;
      is_used[segment] = 1;
      to.push_back(segments[segment]);
      if (end % 2 == 1) std::swap(to.back().p[0], to.back().p[1]);
      end ^= 1U;
    }
  };
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (is_used[i] != 0) continue;
    is_used[i] = 1;
    before.clear();
    follow(2 * i, before);
    for (auto shape = before.rbegin(); shape != before.rend(); ++shape) {
      out.push_back(*shape);
      std::swap(out.back().p[0], out.back().p[1]);
    }
    out.push_back(segments[i]);
    follow(2 * i + 1, out);
  }
  out.insert(out.end(), others.begin(), others.end());
  shapes = std::move(out);
}

std::size_t chain_length(std::span<const Shape> shapes, std::size_t first) {
  std::size_t last = first;
  while (last < shapes.size() && is_chained(shapes[last].kind) &&
         (last == first || shapes[last].p[0] == shapes[last - 1].p[1]))
    ++last;
  return last - first;
}

bool is_loop(std::span<const Shape> chain) {
  return chain.size() > 2 && chain.front().p[0] == chain.back().p[1];
}

}  // namespace mes::figure

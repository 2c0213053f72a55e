// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/outline_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <unordered_map>

#include "core/base/disjoint_sets.h"
#include "core/kernel/point_predicates.h"

namespace mes {
namespace {

/// A sweep over the vertices from left to right. It keeps the sides that cross the sweep line, from bottom to top; a
/// vertical side counts as slightly turned, so that its lower end is its left one.
class RegionSweep {
 public:
  explicit RegionSweep(std::span<const OutlineSide> sides)
      : sides_(sides), crossing_(IsBelow{sides}), at_(sides.size()), is_inside_above_(sides.size()) {
    sets_.reset(sides.size());
  }

  std::vector<std::vector<OutlineSide>> run() {
    std::vector<std::uint32_t> by_end(sides_.size());
    std::iota(by_end.begin(), by_end.end(), 0U);
    std::ranges::sort(by_end, [this](std::uint32_t a, std::uint32_t b) {
      return lexicographically_less(sides_[a].to, sides_[b].to);
    });
    // The sides are sorted by their first ends.
    std::uint32_t begun = 0;
    std::size_t ended = 0;
    while (ended < by_end.size()) {
      const Vec2 end = sides_[by_end[ended]].to;
      const bool begins = begun < sides_.size() && !lexicographically_less(end, sides_[begun].from);
      const Vec2 vertex = begins ? sides_[begun].from : end;
      std::vector<std::uint32_t> left;
      for (; ended < by_end.size() && sides_[by_end[ended]].to == vertex; ++ended) left.push_back(by_end[ended]);
      std::vector<std::uint32_t> right;
      for (; begun < sides_.size() && sides_[begun].from == vertex; ++begun) right.push_back(begun);
      pass(vertex, left, right);
    }
    return parts();
  }

 private:
  /// Sides that cross a common sweep line, and points on it, from bottom to top.
  struct IsBelow {
    using is_transparent = void;
    std::span<const OutlineSide> sides;
    bool operator()(std::uint32_t i, Vec2 p) const { return orientation(sides[i].from, sides[i].to, p) > 0; }
    bool operator()(std::uint32_t i, std::uint32_t j) const {
      const OutlineSide& a = sides[i];
      const OutlineSide& b = sides[j];
      if (a.from == b.from) return orientation(a.from, a.to, b.to) > 0;
      if (lexicographically_less(a.from, b.from)) return orientation(a.from, a.to, b.from) > 0;
      return orientation(b.from, b.to, a.from) < 0;
    }
  };
  using Crossing = std::set<std::uint32_t, IsBelow>;

  void join(std::uint32_t a, std::uint32_t b) { sets_.join(sets_.root(a), sets_.root(b)); }

  void pass(Vec2 vertex, std::span<const std::uint32_t> left, std::span<std::uint32_t> right) {
    for (const std::uint32_t side : left) {
      join(side, left.front());
      crossing_.erase(at_[side]);
    }
    const auto above = crossing_.lower_bound(vertex);
    const bool has_below = above != crossing_.begin();
    const std::uint32_t below = has_below ? *std::prev(above) : 0;
    bool is_inside = has_below && is_inside_above_[below];
    if (right.empty()) return;
    for (const std::uint32_t side : right) join(side, left.empty() ? right.front() : left.front());
    // The region to the left of the vertex lies on the side below, too.
    if (left.empty() && is_inside) join(right.front(), below);
    std::ranges::sort(right, crossing_.key_comp());
    for (const std::uint32_t side : right) {
      is_inside = is_inside != sides_[side].separates;
      is_inside_above_[side] = is_inside;
      at_[side] = crossing_.emplace_hint(above, side);
    }
  }

  std::vector<std::vector<OutlineSide>> parts() {
    std::vector<bool> has_inside(sides_.size());
    for (std::uint32_t i = 0; i < sides_.size(); ++i)
      if (is_inside_above_[i] || sides_[i].separates) has_inside[sets_.root(i)] = true;
    std::vector<std::vector<OutlineSide>> out;
    std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> stretches;
    std::unordered_map<std::uint32_t, std::size_t> part_of;
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      const std::uint32_t root = sets_.root(i);
      if (!has_inside[root]) continue;
      const auto [part, is_new] = part_of.try_emplace(root, out.size());
      if (is_new) {
        out.emplace_back();
        stretches.emplace_back();
      }
      OutlineSide& side = out[part->second].emplace_back(sides_[i]);
      if (side.smooth.stretch == SmoothPlace::kNone) continue;
      auto& known = stretches[part->second];
      side.smooth.stretch =
          known.try_emplace(side.smooth.stretch, static_cast<std::uint32_t>(known.size())).first->second;
    }
    return out;
  }

  std::span<const OutlineSide> sides_;
  Crossing crossing_;
  std::vector<Crossing::iterator> at_;
  std::vector<bool> is_inside_above_;  // of each side, directly above it
  DisjointSets<RowNumber> sets_;
};

}  // namespace

std::vector<std::vector<OutlineSide>> independent_parts(std::span<const OutlineSide> sides) {
  return RegionSweep(sides).run();
}

}  // namespace mes

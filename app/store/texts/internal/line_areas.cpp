// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/internal/line_areas.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "core/base/geometry/box_tree.h"
#include "core/kernel/point_predicates.h"

namespace mes {
namespace {

using Ring = std::vector<Vec2>;

/// An end of a line, from which one may go along it.
struct LineEnd {
  std::size_t line = 0;
  bool is_last = false;
};

/// The lines as a graph whose nodes are their ends.
class LineGraph {
 public:
  explicit LineGraph(std::vector<Ring> lines) : lines_(std::move(lines)), is_used_(lines_.size()) {
    for (const Ring& line : lines_) places_.insert(places_.end(), {line.front(), line.back()});
    std::ranges::sort(places_, lexicographically_less);
    places_.erase(std::ranges::unique(places_).begin(), places_.end());
    ends_.resize(places_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (const bool is_last : {false, true}) ends_[node_of({i, is_last})].push_back({i, is_last});
  }

  /// Drops lines that are not parts of rings, and returns their number.
  std::uint64_t drop_open_lines() {
    std::uint64_t out = 0;
    std::vector<std::size_t> waiting(places_.size());
    std::iota(waiting.begin(), waiting.end(), std::size_t{0});
    const auto drop_lines_at = [&](std::size_t node) {
      for (const LineEnd& end : ends_[node]) {
        if (is_used_[end.line]) continue;
        is_used_[end.line] = true;
        ++out;
        for (const bool is_last : {false, true}) waiting.push_back(node_of({end.line, is_last}));
      }
    };
    const auto take = [&waiting] {
      const std::size_t node = waiting.back();
      waiting.pop_back();
      return node;
    };
    while (!waiting.empty())
      if (const std::size_t node = take(); degree_of(node) == 1) drop_lines_at(node);
    for (std::size_t node = 0; node < places_.size(); ++node)
      if (degree_of(node) % 2 == 1) waiting.push_back(node);
    while (!waiting.empty()) drop_lines_at(take());
    return out;
  }

  /// Simple rings that use each line once and do not cross.
  std::vector<Ring> rings() {
    std::vector<Ring> out;
    std::vector<std::optional<std::size_t>> step_at(places_.size());  // the step of the walk that left a node
    for (std::size_t first = 0; first < lines_.size(); ++first) {
      if (is_used_[first]) continue;
      std::vector<LineEnd> walk;
      for (LineEnd next{first, false};;) {
        step_at[node_of(next)] = walk.size();
        walk.push_back(next);
        is_used_[next.line] = true;
        const LineEnd reached{next.line, !next.is_last};
        const std::size_t node = node_of(reached);
        if (const auto begin = step_at[node]) {
          out.push_back(ring_of(std::span(walk).subspan(*begin)));
          for (std::size_t i = *begin; i < walk.size(); ++i) step_at[node_of(walk[i])].reset();
          walk.resize(*begin);
        }
        if (walk.empty()) break;
        // All degrees are even, so a node that was reached can be left.
        next = *next_end(reached);
      }
    }
    return out;
  }

 private:
  Vec2 place(const LineEnd& end) const { return end.is_last ? lines_[end.line].back() : lines_[end.line].front(); }
  /// The point of the line beside its end.
  Vec2 beside(const LineEnd& end) const {
    const Ring& line = lines_[end.line];
    return end.is_last ? line[line.size() - 2] : line[1];
  }
  std::size_t node_of(const LineEnd& end) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(places_, place(end), lexicographically_less) -
                                    places_.begin());
  }
  std::size_t degree_of(std::size_t node) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(ends_[node], [&](const LineEnd& end) { return !is_used_[end.line]; }));
  }

  /// The unused line that comes first counter-clockwise from the one by which the node was reached.
  std::optional<LineEnd> next_end(const LineEnd& reached) const {
    const Vec2 center = place(reached);
    const Vec2 back = beside(reached);
    const auto part_of_turn = [&](Vec2 p) {
      const int side = orientation(center, back, p);
      if (side != 0) return side > 0 ? 0 : 2;
      return dot(p - center, back - center) < 0.0 ? 1 : 3;
    };
    std::optional<LineEnd> out;
    for (const LineEnd& end : ends_[node_of(reached)]) {
      if (is_used_[end.line]) continue;
      const Vec2 p = beside(end);
      const bool is_first =
          !out || part_of_turn(p) < part_of_turn(beside(*out)) ||
          (part_of_turn(p) == part_of_turn(beside(*out)) && orientation(center, p, beside(*out)) > 0);
      if (is_first) out = end;
    }
    return out;
  }

  Ring ring_of(std::span<const LineEnd> walk) const {
    Ring out;
    for (const LineEnd& step : walk) {
      const Ring& line = lines_[step.line];
      if (step.is_last)
        out.insert(out.end(), line.rbegin(), line.rend() - 1);
      else
        out.insert(out.end(), line.begin(), line.end() - 1);
    }
    return out;
  }

  std::vector<Ring> lines_;
  std::vector<bool> is_used_;
  std::vector<Vec2> places_;  // of the nodes, in lexicographic order
  std::vector<std::vector<LineEnd>> ends_;
};

/// A side of a ring, with the ends ordered.
struct Side {
  Vec2 left{}, right{};
  std::uint32_t ring = 0;
  bool is_lower = false;  ///< the inside of the ring is above
};

/// Whether one side is above another, which it does not cross, where both have points on an upright line. Of two that
/// run along each other, the one that bounds what lies above them counts as above: the lower side of a ring, then that
/// of the inner of two rings, the later one; of two upper sides that of the outer ring.
bool is_above(const Side& a, const Side& b) {
  const bool begins_later = !lexicographically_less(a.left, b.left);
  const Side& early = begins_later ? b : a;
  const Side& late = begins_later ? a : b;
  int side = orientation(early.left, early.right, late.left);
  if (side == 0) side = orientation(early.left, early.right, late.right);
  if (side != 0) return (side > 0) == begins_later;
  if (a.is_lower != b.is_lower) return a.is_lower;
  return a.is_lower ? a.ring > b.ring : a.ring < b.ring;
}

/// A counter-clockwise ring that begins at its smallest point; empty: it encloses nothing.
Ring begun_at_smallest(Ring ring) {
  ring.erase(std::ranges::unique(ring).begin(), ring.end());
  if (ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return {};
  std::ranges::rotate(ring, std::ranges::min_element(ring, lexicographically_less));
  const int turn = orientation(ring.back(), ring[0], ring[1]);
  if (turn == 0) return {};
  if (turn < 0) std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

/// From left to right; of rings with the same smallest point, the lower first, and one around another first. Rings may
/// have parts of sides in common.
bool comes_before(const Ring& a, const Ring& b) {
  if (a[0] != b[0]) return lexicographically_less(a[0], b[0]);
  if (const int turn = orientation(a[0], a[1], b[1]); turn != 0) return turn > 0;
  if (const int turn = orientation(a[0], a.back(), b.back()); turn != 0) return turn < 0;
  return area_of(a) > area_of(b);
}

/// The ring directly around each; none: the number of rings. The rings are in the order above.
std::vector<std::size_t> surroundings_of(const std::vector<Ring>& rings) {
  std::vector<Side> sides;
  for (std::uint32_t i = 0; i < rings.size(); ++i) {
    for (std::size_t k = 0; k < rings[i].size(); ++k) {
      const Vec2 a = rings[i][k];
      const Vec2 b = rings[i][(k + 1) % rings[i].size()];
      if (a.x != b.x) sides.push_back({a.x < b.x ? a : b, a.x < b.x ? b : a, i, a.x < b.x});
    }
  }
  BoxTree<Side> tree;
  tree.build(
      std::span<const Side>(sides),
      [](const Side& side) {
        TreeBounds out;
        out.box.add(side.left);
        out.box.add(side.right);
        return out;
      },
      [](const Side&, std::uint32_t) {});
  std::vector<std::size_t> out(rings.size(), rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Vec2 p = rings[i][0];
    const Vec2 lower = rings[i][1];
    std::optional<Side> below;
    const auto may_hold = [&](const Box2& box, double) {
      return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y &&
             (!below || box.high.y >= std::min(below->left.y, below->right.y));
    };
    tree.visit_where(may_hold, [&](const Side& side) {
      // A ring that comes later neither surrounds this one nor lies directly below it.
      if (side.ring >= i || side.left.x > p.x || side.right.x <= p.x) return;
      const int turn = orientation(side.left, side.right, p);
      if (turn < 0 || (turn == 0 && orientation(p, side.right, lower) < 0)) return;
      if (!below || is_above(side, *below)) below = side;
    });
    if (below) out[i] = below->is_lower ? below->ring : out[below->ring];
  }
  return out;
}

}  // namespace

double area_of(const std::vector<Vec2>& ring) {
  double out = 0.0;
  for (std::size_t i = 2; i < ring.size(); ++i) out += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return 0.5 * out;
}

LineAreas areas_of(std::vector<std::vector<Vec2>> lines) {
  std::erase_if(lines, [](const Ring& line) { return line.size() < 2; });
  LineGraph graph(std::move(lines));
  LineAreas out{.areas = {}, .left_out = graph.drop_open_lines()};
  std::vector<Ring> rings = graph.rings();
  for (Ring& ring : rings) ring = begun_at_smallest(std::move(ring));
  std::erase_if(rings, [](const Ring& ring) { return ring.empty(); });
  std::ranges::sort(rings, comes_before);
  const std::vector<std::size_t> around = surroundings_of(rings);
  std::vector<bool> is_hole(rings.size());
  std::vector<std::size_t> number_of_area(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    is_hole[i] = around[i] < rings.size() && !is_hole[around[i]];
    Ring& ring = rings[i];
    ring.push_back(ring.front());
    if (is_hole[i]) {
      std::ranges::reverse(ring);
      out.areas[number_of_area[around[i]]].holes.push_back(std::move(ring));
    } else {
      number_of_area[i] = out.areas.size();
      out.areas.push_back({std::move(ring), {}});
    }
  }
  return out;
}

}  // namespace mes

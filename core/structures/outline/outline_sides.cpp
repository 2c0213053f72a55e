// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/outline_sides.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/curves/curve_bounds.h"
#include "core/graph/size_refusal.h"
#include "core/kernel/point_predicates.h"
#include "core/structures/outline/internal/chords.h"
#include "core/structures/outline/internal/curve_chords.h"
#include "core/structures/outline/internal/outline_pieces.h"
#include "core/structures/outline/internal/side_geometry.h"

namespace mes {
namespace {

constexpr std::size_t kOften = 4096;
/// An outline with more crossings takes minutes, and has more parts than anybody looks at.
constexpr std::size_t kMostCrossings = 200'000;

bool by_ends(const OutlineSide& a, const OutlineSide& b) {
  return std::tie(a.from.x, a.from.y, a.to.x, a.to.y) < std::tie(b.from.x, b.from.y, b.to.x, b.to.y);
}

/// The crossing, rounded.
Vec2 crossing_of(const OutlineSide& a, const OutlineSide& b) {
  const Vec2 along = a.to - a.from;
  const Vec2 other = b.to - b.from;
  return a.from + (cross(b.from - a.from, other) / cross(along, other)) * along;
}

/// Moves points that lie together to one of them. Where many sides cross at one point, each two have a crossing of their
/// own, and these differ by rounding alone. Points lie together if neighbouring cells, of the size of the tolerance, hold
/// them.
class JoinedPoints {
 public:
  JoinedPoints(std::span<const Vec2> points, double tolerance) : tolerance_(tolerance) {
    for (const Vec2 p : points) {
      const auto [at, is_new] = cells_.try_emplace(cell_of(p), Cell{p, nullptr});
      if (!is_new && lexicographically_less(p, at->second.point)) at->second.point = p;
    }
    for (auto& [cell, content] : cells_)
      for (const auto& step : {Number{0.0, 1.0}, Number{1.0, -1.0}, Number{1.0, 0.0}, Number{1.0, 1.0}})
        if (const auto beside = cells_.find({cell.first + step.first, cell.second + step.second});
            beside != cells_.end())
          join(first_of(content), first_of(beside->second));
  }
  /// For one of the points.
  Vec2 place_of(Vec2 p) { return first_of(cells_.at(cell_of(p))).point; }

 private:
  using Number = std::pair<double, double>;
  struct Cell {
    Vec2 point;    // the smallest in the cell, then among those that were joined
    Cell* joined;  // null for the cell that stands for others
  };
  Number cell_of(Vec2 p) const { return {std::floor(p.x / tolerance_), std::floor(p.y / tolerance_)}; }
  static Cell& first_of(Cell& cell) {
    Cell* first = &cell;
    while (first->joined != nullptr) first = first->joined;
    if (first != &cell) cell.joined = first;
    return *first;
  }
  static void join(Cell& a, Cell& b) {
    if (&a == &b) return;
    if (lexicographically_less(b.point, a.point)) a.point = b.point;
    b.joined = &a;
  }

  double tolerance_;
  std::map<Number, Cell> cells_;
};

/// True for a point of the line through the side if it lies inside it; points on it are in this order.
bool is_between(Vec2 p, const OutlineSide& side) {
  return lexicographically_less(side.from, p) && lexicographically_less(p, side.to);
}

/// Whether two sides are collinear and have more than a point in common.
bool have_common_part(const OutlineSide& a, const OutlineSide& b) {
  return lexicographically_less(a.from, b.to) && lexicographically_less(b.from, a.to) &&
         orientation(a.from, a.to, b.from) == 0 && orientation(a.from, a.to, b.to) == 0;
}

/// All ends, each once, sorted.
std::vector<Vec2> ends_of(std::span<const OutlineSide> sides) {
  std::vector<Vec2> out;
  out.reserve(2 * sides.size());
  for (const OutlineSide& side : sides) {
    out.push_back(side.from);
    out.push_back(side.to);
  }
  std::ranges::sort(out, lexicographically_less);
  const auto rest = std::ranges::unique(out);
  out.erase(rest.begin(), rest.end());
  return out;
}

}  // namespace

bool SmoothPlace::is_next_to(const SmoothPlace& other) const {
  if (stretch == kNone || stretch != other.stretch) return false;
  const std::uint32_t apart = std::max(number, other.number) - std::min(number, other.number);
  constexpr std::uint32_t kTwoChords = 4;
  return std::min(apart, count == 0 ? apart : count - apart) <= kTwoChords;
}

OutlineFaults faults_of_outlines(std::span<const PlaneCurve> curves, JobControl& job) {
  OutlineFaults out;
  std::vector<OutlineSide> sides;
  struct Use {
    std::uint32_t outline = 0;
    bool is_below = false;  ///< the outline lies above the side
  };
  std::vector<Use> uses;
  CurveChords chords(curves, outline_tolerance(curves), job);
  std::uint32_t outline = 0;
  out.same = for_each_outline(curves, [&](const PlaneCurve& curve, std::span<const Piece> pieces) {
    std::vector<OutlineSide> own;
    double twice_area = 0.0;
    const Vec2 origin = pieces.front().from();
    const auto add = [&](Vec2 from, Vec2 to, std::optional<Vec2> center) {
      if (from == to) return;
      twice_area += cross(from - origin, to - origin);
      const bool is_forward = lexicographically_less(from, to);
      own.push_back(
          {.from = is_forward ? from : to, .to = is_forward ? to : from, .separates = is_forward, .center = center});
    };
    for (const Piece& piece : pieces) {
      Vec2 at = piece.from();
      for (const OutlineChord& chord : chords.next()) add(std::exchange(at, chord.to), chord.to, chord.center);
    }
    if (!curve.is_closed()) return;
    std::ranges::sort(own, by_ends);
    const auto are_equal = [](const OutlineSide& a, const OutlineSide& b) {
      return a.from == b.from && a.to == b.to;
    };
    const auto rest = std::ranges::unique(own, are_equal);
    out.repeated += rest.size();
    own.erase(rest.begin(), rest.end());
    for (const OutlineSide& side : own) {
      sides.push_back({.from = side.from, .to = side.to, .center = side.center});
      uses.push_back({outline, side.separates == (twice_area > 0.0)});
    }
    ++outline;
  });
  const double least = least_height(sides);
  for_each_meeting(sides, job, [&](std::uint32_t i, std::uint32_t j) {
    if (have_common_part(sides[i], sides[j])) {
      if (uses[i].outline == uses[j].outline)
        ++out.repeated;
      else if (uses[i].is_below == uses[j].is_below)
        ++out.overlaps;
    }
    if (!cross_inside(sides[i], sides[j]) || meeting_of(sides[i], sides[j], least) == Meeting::touches) return true;
    return ++out.crossings <= kMostCrossings;
  });
  return out;
}

double outline_tolerance(std::span<const PlaneCurve> curves) {
  const Box2 box = bounds_of(curves);
  return box.is_empty() ? 0.0 : 0x1p-14 * std::max(box.width(), box.height());
}

void OutlineSides::add(OutlineSide side) {
  if (side.from == side.to) return;
  if (lexicographically_less(side.to, side.from)) std::swap(side.from, side.to);
  sides_.push_back(side);
}

void OutlineSides::add(Vec2 from, Vec2 to, bool is_of_closed_contour) {
  add(OutlineSide{.from = from, .to = to, .separates = is_of_closed_contour});
}

void OutlineSides::add(std::span<const PlaneCurve> curves, double tolerance, JobControl& job) {
  CurveChords chords(curves, tolerance, job);
  for_each_outline(curves, [&](const PlaneCurve& curve, std::span<const Piece> pieces) {
    std::vector<std::span<const OutlineChord>> own;
    for (std::size_t i = 0; i < pieces.size(); ++i) own.push_back(chords.next());
    add(pieces, own, curve.is_closed(), tolerance);
  });
}

void OutlineSides::add(std::span<const Piece> pieces, std::span<const std::span<const OutlineChord>> chords,
                       bool is_closed, double tolerance) {
  const std::size_t count = pieces.size();
  // In drawings with few decimals a short line closes the gap between two ends. The curve goes on smoothly across it.
  const auto is_gap = [&](std::size_t i) {
    return pieces[i].kind == PieceKind::line && distance(pieces[i].from(), pieces[i].to()) <= tolerance;
  };
  const auto goes_on_after = [&](std::size_t i) {
    std::size_t before = i;
    std::size_t after = i + 1;
    if (is_gap(before) && (is_closed || before != 0)) before += count - 1;
    if ((is_closed || after < count) && is_gap(after % count)) ++after;
    if (after >= count && !is_closed) return false;
    const Piece& first = pieces[before % count];
    const Piece& next = pieces[after % count];
    if (first.kind == PieceKind::line && next.kind == PieceKind::line) return false;
    return go_on(first.last_direction(), next.first_direction());
  };
  // Begin behind a corner, so that no stretch passes the beginning; a closed curve without corners is one stretch.
  std::size_t first = 0;
  while (first < count && goes_on_after((first + count - 1) % count)) ++first;
  const bool is_round = first == count;
  const std::size_t begin = sides_.size();
  SmoothPlace place{.stretch = stretches_++};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    Vec2 at = pieces[i].from();
    for (const OutlineChord& chord : chords[i]) {
      add({at, chord.to, is_closed, place, chord.center, chord.is_arc});
      if (at != chord.to) place.number += 2;
      at = chord.to;
    }
    if (!goes_on_after(i)) place = {.stretch = stretches_++};
  }
  if (is_round)
    for (std::size_t i = begin; i < sides_.size(); ++i) sides_[i].smooth.count = place.number;
}

std::vector<OutlineSides::Cut> OutlineSides::ends_on_sides(JobControl& job) const {
  const std::vector<Vec2> ends = ends_of(sides_);
  const BoxTree<std::uint32_t> tree = tree_of(sides_);
  std::vector<Cut> cuts;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (k % kOften == 0) job.checkpoint();
    const Vec2 end = ends[k];
    tree.visit_where([end](const Box2& box, double) { return box.contains(end); },
                     [&](std::uint32_t i) {
                       const OutlineSide& side = sides_[i];
                       if (is_between(end, side) && orientation(side.from, side.to, end) == 0)
                         cuts.emplace_back(i, end);
                     });
  }
  return cuts;
}

// Sides that are nearly collinear, or cross near an end, are split at ends: then splitting does not go on, since each
// round adds few points.
void OutlineSides::add_cuts_of_crossing(std::uint32_t i, std::uint32_t j, double tolerance,
                                        std::vector<Cut>& cuts) const {
  const OutlineSide& a = sides_[i];
  const OutlineSide& b = sides_[j];
  const std::size_t before = cuts.size();
  const auto split_at_end = [&](std::uint32_t number, const OutlineSide& side, Vec2 end) {
    if (can_split(end, side) && distance_from_chord(end, side.from, side.to) <= tolerance)
      cuts.emplace_back(number, end);
  };
  for (const Vec2 end : {b.from, b.to}) split_at_end(i, a, end);
  for (const Vec2 end : {a.from, a.to}) split_at_end(j, b, end);
  if (cuts.size() != before) return;
  const Vec2 at = crossing_of(a, b);
  if (!is_finite(at)) return;
  if (can_split(at, a)) cuts.emplace_back(i, at);
  if (can_split(at, b)) cuts.emplace_back(j, at);
}

std::optional<std::vector<OutlineSides::Cut>> OutlineSides::crossings_of_sides(JobControl& job,
                                                                               std::size_t& crossings) const {
  const double tolerance = least_height(sides_);
  std::vector<Cut> cuts;
  std::size_t met = 0;
  for_each_meeting(sides_, job, [&](std::uint32_t i, std::uint32_t j) {
    if (!cross_inside(sides_[i], sides_[j])) return true;
    add_cuts_of_crossing(i, j, tolerance, cuts);
    if (meeting_of(sides_[i], sides_[j], tolerance) != Meeting::touches) ++crossings;
    return ++met <= kMostCrossings;
  });
  if (met == 0) return std::nullopt;
  if (met > kMostCrossings)
    throw SizeRefusal(fmt::format("the sides of the outline cross each other more than {} times", kMostCrossings));
  std::vector<Vec2> points;
  for (const Cut& cut : cuts) points.push_back(cut.second);
  JoinedPoints joined(points, tolerance);
  for (Cut& cut : cuts) cut.second = joined.place_of(cut.second);
  std::erase_if(cuts, [this](const Cut& cut) { return !can_split(cut.second, sides_[cut.first]); });
  return cuts;
}

void OutlineSides::split(std::vector<Cut> cuts, Cuts where) {
  // Points on a side lie in lexicographic order from its first end to its second.
  const auto along = [&](const Cut& cut) {
    return where == Cuts::beside_sides ? share_along(cut.second, sides_[cut.first]) : 0.0;
  };
  std::ranges::sort(cuts, [&](const Cut& a, const Cut& b) {
    return std::tuple(a.first, along(a), a.second.x, a.second.y) <
           std::tuple(b.first, along(b), b.second.x, b.second.y);
  });
  std::vector<OutlineSide> pieces;
  for (std::size_t k = 0; k < cuts.size();) {
    const std::uint32_t i = cuts[k].first;
    const OutlineSide side = sides_[i];
    Vec2 at = side.from;
    const auto go_to = [&](Vec2 next) {
      if (next == at) return;
      const auto [from, to] = std::minmax(at, next, lexicographically_less);
      pieces.push_back({from, to, side.separates, side.smooth, side.center, side.is_arc});
      at = next;
    };
    for (; k < cuts.size() && cuts[k].first == i; ++k) go_to(cuts[k].second);
    go_to(side.to);
    sides_[i] = pieces.back();
    pieces.pop_back();
  }
  sides_.insert(sides_.end(), pieces.begin(), pieces.end());
  merge();
}

void OutlineSides::merge() {
  std::ranges::stable_sort(sides_, by_ends);
  std::vector<OutlineSide> out;
  for (const OutlineSide& side : sides_) {
    if (out.empty() || by_ends(out.back(), side)) {
      out.push_back(side);
      continue;
    }
    OutlineSide& same = out.back();
    same.separates = same.separates != side.separates;
    const bool is_less = same.center && (!side.center || lexicographically_less(*side.center, *same.center));
    if (is_less) {
      same.center = side.center;
      same.is_arc = side.is_arc;
    }
  }
  sides_.swap(out);
}

std::vector<OutlineSide> OutlineSides::take(JobControl& job) {
  merge();
  split(ends_on_sides(job), Cuts::on_sides);
  constexpr int kMostRounds = 32;
  for (int round = 0;; ++round) {
    std::size_t crossings = 0;
    auto cuts = crossings_of_sides(job, crossings);
    if (!cuts) return std::move(sides_);
    if (round == 0) crossings_ = crossings;  // later ones are caused by rounding
    if (round == kMostRounds) throw GeometryError("the sides of the outline cross too often at almost one point");
    split(std::move(*cuts), Cuts::beside_sides);
    split(ends_on_sides(job), Cuts::on_sides);
  }
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/outline_sides.h"

#include <fmt/core.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/geometry/box_tree.h"
#include "core/curves/curve_bounds.h"
#include "core/graph/size_refusal.h"
#include "core/kernel/point_predicates.h"
#include "core/structures/outline/internal/chords.h"

namespace mes {
namespace {

constexpr std::size_t kOften = 4096;
/// An outline with more crossings takes minutes, and has more parts than anybody looks at.
constexpr std::size_t kMostCrossings = 200'000;

bool by_ends(const OutlineSide& a, const OutlineSide& b) {
  return std::tie(a.from.x, a.from.y, a.to.x, a.to.y) < std::tie(b.from.x, b.from.y, b.to.x, b.to.y);
}

double radius_of(const OutlineSide& side) {
  return 0.5 * (distance(side.from, *side.center) + distance(side.to, *side.center));
}

/// The bow of a side reaches as far from it, in heights.
constexpr double kBow = 4.0;

/// How far the circle of a side leaves it.
double height_of(const OutlineSide& side) {
  const Vec2 chord = side.to - side.from;
  return side.center ? dot(chord, chord) / (8.0 * radius_of(side)) : 0.0;
}

/// The middle of the arc that the side stands for.
Vec2 middle_of(const OutlineSide& side) {
  const Vec2 middle = 0.5 * side.from + 0.5 * side.to;
  if (!side.center) return middle;
  const Vec2 way = middle - *side.center;
  const double size = length(way);
  return size > 0.0 ? *side.center + (radius_of(side) / size) * way : middle;
}

/// The box holds the side and its bow.
Box2 box_of(const OutlineSide& side) {
  Box2 box;
  box.add(side.from);
  box.add(side.to);
  if (!side.center) return box;
  const Vec2 margin = kBow * height_of(side) * Vec2{1.0, 1.0};
  return {box.low - margin, box.high + margin};
}

BoxTree<std::uint32_t> tree_of(std::span<const OutlineSide> sides) {
  std::vector<std::uint32_t> numbers(sides.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers), [sides](std::uint32_t i) { return TreeBounds{box_of(sides[i])}; },
      [](std::uint32_t, std::uint32_t) {});
  return tree;
}

/// True for a point of the line through the side if it lies inside it; points on it are in this order.
bool is_between(Vec2 p, const OutlineSide& side) {
  return lexicographically_less(side.from, p) && lexicographically_less(p, side.to);
}

/// The crossing, rounded.
Vec2 crossing_of(const OutlineSide& a, const OutlineSide& b) {
  const Vec2 along = a.to - a.from;
  const Vec2 other = b.to - b.from;
  return a.from + (cross(b.from - a.from, other) / cross(along, other)) * along;
}

/// The foot of a point on the line through a side: 0 at its first end, 1 at its second.
double share_along(Vec2 p, const OutlineSide& side) {
  const Vec2 along = side.to - side.from;
  return dot(p - side.from, along) / dot(along, along);
}

/// True if the point can split the side, which it need not lie on.
bool can_split(Vec2 p, const OutlineSide& side) {
  const double share = share_along(p, side);
  return p != side.from && p != side.to && share > 0.0 && share < 1.0;
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

/// Whether two sides cross at a point which is an end of neither.
bool cross_inside(const OutlineSide& a, const OutlineSide& b) {
  return orientation(a.from, a.to, b.from) * orientation(a.from, a.to, b.to) < 0 &&
         orientation(b.from, b.to, a.from) * orientation(b.from, b.to, a.to) < 0;
}

/// Whether two sides are collinear and have more than a point in common.
bool have_common_part(const OutlineSide& a, const OutlineSide& b) {
  return lexicographically_less(a.from, b.to) && lexicographically_less(b.from, a.to) &&
         orientation(a.from, a.to, b.from) == 0 && orientation(a.from, a.to, b.to) == 0;
}

/// Calls `use(i, j)` for each two sides whose boxes meet, until it returns false.
void for_each_meeting(std::span<const OutlineSide> sides, JobControl& job, auto use) {
  const BoxTree<std::uint32_t> tree = tree_of(sides);
  bool goes_on = true;
  for (std::uint32_t i = 0; i < sides.size() && goes_on; ++i) {
    constexpr std::uint32_t kRatherOften = 64;  // a side may cross all others
    if (i % kRatherOften == 0) job.checkpoint();
    const Box2 own = box_of(sides[i]);
    tree.visit_where([&](const Box2& box, double) { return goes_on && overlap(own, box); },
                     [&](std::uint32_t j) {
                       if (j > i && goes_on && overlap(own, box_of(sides[j]))) goes_on = use(i, j);
                     });
  }
}

bool is_same(const Piece& a, const Piece& b) {
  return a.kind == b.kind && a.points == b.points && a.arc == b.arc;
}

/// The pieces that are no points. A closed curve that goes around several times in the same way has those of one time.
std::vector<Piece> pieces_of(const PlaneCurve& curve) {
  std::vector<Piece> out;
  curve.for_each_piece([&](const Piece& piece) {
    if (piece.kind != PieceKind::line || piece.from() != piece.to()) out.push_back(piece);
  });
  if (!curve.is_closed() || out.empty()) return out;
  // The border of a beginning is the longest shorter one with which it ends as well (Knuth, Morris and Pratt, 1977).
  std::vector<std::size_t> border(out.size(), 0);
  for (std::size_t i = 1; i < out.size(); ++i) {
    std::size_t size = border[i - 1];
    while (size != 0 && !is_same(out[size], out[i])) size = border[size - 1];
    border[i] = is_same(out[size], out[i]) ? size + 1 : 0;
  }
  const std::size_t period = out.size() - border.back();
  if (out.size() % period == 0) out.resize(period);
  return out;
}

/// Whether two closed curves are the same in the same direction, wherever they begin.
bool go_around_alike(std::span<const Piece> a, std::span<const Piece> b) {
  if (a.size() != b.size()) return false;
  const auto first = std::ranges::find_if(b, [&](const Piece& piece) { return is_same(piece, a.front()); });
  const auto rest = static_cast<std::size_t>(b.end() - first);
  return std::ranges::equal(a.first(rest), b.last(rest), is_same) &&
         std::ranges::equal(a.last(a.size() - rest), b.first(b.size() - rest), is_same);
}

/// A number that does not depend on where the curve begins.
std::uint64_t fingerprint(std::span<const Piece> pieces) {
  std::uint64_t sum = 0;
  for (const Piece& piece : pieces) {
    std::uint64_t own = 0;
    for (const double x : {piece.from().x, piece.from().y, piece.to().x, piece.to().y}) {
      constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;                         // 2^64 over the golden ratio
      own = std::rotl((own ^ std::bit_cast<std::uint64_t>(x + 0.0)) * kOdd, 29);  // + 0.0: -0 equals 0
    }
    sum += own;
  }
  return sum;
}

/// Calls `use(curve, pieces)` for each curve that has pieces, except closed ones that repeat another one. Returns how
/// many these were.
std::size_t for_each_outline(std::span<const PlaneCurve> curves, auto use) {
  std::unordered_map<std::uint64_t, std::vector<const PlaneCurve*>> alike;
  std::size_t repeats = 0;
  for (const PlaneCurve& curve : curves) {
    const std::vector<Piece> pieces = pieces_of(curve);
    if (pieces.empty()) continue;
    if (curve.is_closed()) {
      std::vector<const PlaneCurve*>& others = alike[fingerprint(pieces)];
      const auto is_repeat = [&](const PlaneCurve* other) { return go_around_alike(pieces, pieces_of(*other)); };
      if (std::ranges::any_of(others, is_repeat)) {
        ++repeats;
        continue;
      }
      others.push_back(&curve);
    }
    use(curve, pieces);
  }
  return repeats;
}

/// How two curves meet whose chords cross: it is unclear while chords alone may cross.
enum class Meeting : std::uint8_t { crosses, touches, unclear };

/// Whether a point is so near the side that the axis between them depends on which chords the curve has.
bool is_in_bow(Vec2 p, const OutlineSide& side) {
  return side.center && can_split(p, side) && distance_from_chord(p, side.from, side.to) <= kBow * height_of(side);
}

bool are_on_one_circle(const OutlineSide& a, const OutlineSide& b, double least) {
  return a.center && b.center && distance(*a.center, *b.center) <= least &&
         std::abs(radius_of(a) - radius_of(b)) <= least;
}

/// How the curves of two sides meet that cross inside. They cross where the angle between the sides is much larger than
/// those by which the curves turn along them. Curves whose chords leave them by no more than `least` touch.
Meeting meeting_of(const OutlineSide& a, const OutlineSide& b, double least) {
  const Vec2 along = a.to - a.from;
  const Vec2 other = b.to - b.from;
  constexpr double kLarge = 2.0;
  const auto turn = [](const OutlineSide& side, Vec2 chord) {
    return side.center ? length(chord) / radius_of(side) : 0.0;
  };
  if (std::abs(cross(along, other)) >= kLarge * (turn(a, along) + turn(b, other)) * length(along) * length(other))
    return Meeting::crosses;
  return std::max(height_of(a), height_of(b)) <= least ? Meeting::touches : Meeting::unclear;
}

/// Chords that leave their curves by less are those of the curve to rounding.
double least_height(std::span<const OutlineSide> sides) {
  Box2 extent;
  for (const OutlineSide& side : sides) extent.add(box_of(side));
  return 0x1p-44 *
         std::max({std::abs(extent.low.x), std::abs(extent.low.y), std::abs(extent.high.x), std::abs(extent.high.y)});
}

/// The chords of the pieces of all outlines, in the order of `for_each_outline`.
class CurveChords {
 public:
  CurveChords(std::span<const PlaneCurve> curves, double tolerance, JobControl& job) {
    for_each_outline(curves, [&](const PlaneCurve& /*curve*/, std::span<const Piece> pieces) {
      for (const Piece& piece : pieces) {
        starts_.push_back(piece.from());
        add_chords_of(piece, tolerance, chords_);
        ends_.push_back(chords_.size());
      }
    });
    // Chords of curves that touch cross near the point, and those of a thin lens are the same. Each round halves them.
    constexpr int kMostRounds = 64;
    const std::size_t most = 8 * chords_.size() + kOften;
    for (int round = 0; round < kMostRounds && chords_.size() <= most && refine(job); ++round) {
    }
  }

  /// Returns the chords of the next piece.
  std::span<const OutlineChord> next() {
    const std::size_t begin = next_ == 0 ? 0 : ends_[next_ - 1];
    const std::size_t end = ends_[next_++];
    return std::span(chords_).subspan(begin, end - begin);
  }

 private:
  std::vector<OutlineSide> sides() const {
    std::vector<OutlineSide> out;
    out.reserve(chords_.size());
    for (std::size_t piece = 0; piece < starts_.size(); ++piece) {
      Vec2 at = starts_[piece];
      for (std::size_t i = piece == 0 ? 0 : ends_[piece - 1]; i < ends_[piece]; ++i) {
        const auto [from, to] = std::minmax(at, chords_[i].to, lexicographically_less);
        out.push_back({.from = from, .to = to, .center = chords_[i].center});
        at = chords_[i].to;
      }
    }
    return out;
  }

  /// Halves chords that cross or are equal where their curves need not, and those near the ends of others. Returns whether
  /// it found some.
  bool refine(JobControl& job) {
    if (std::ranges::none_of(chords_, [](const OutlineChord& chord) { return chord.center.has_value(); }))
      return false;
    const std::vector<OutlineSide> all = sides();
    const double least = least_height(all);
    std::vector<bool> is_halved(all.size(), false);
    for_each_meeting(all, job, [&](std::uint32_t i, std::uint32_t j) {
      const OutlineSide& a = all[i];
      const OutlineSide& b = all[j];
      if ((!a.center && !b.center) || are_on_one_circle(a, b, least)) return true;
      const bool are_equal = a.from == b.from && a.to == b.to;
      const bool is_unclear = are_equal ? distance(middle_of(a), middle_of(b)) > least
                                        : cross_inside(a, b) && meeting_of(a, b, least) == Meeting::unclear;
      if (is_unclear || is_in_bow(b.from, a) || is_in_bow(b.to, a))
        is_halved[i] = is_halved[i] || height_of(a) > least;
      if (is_unclear || is_in_bow(a.from, b) || is_in_bow(a.to, b))
        is_halved[j] = is_halved[j] || height_of(b) > least;
      return true;
    });
    if (std::ranges::find(is_halved, true) == is_halved.end()) return false;
    std::vector<OutlineChord> finer;
    std::size_t piece = 0;
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      for (; ends_[piece] == i; ++piece) ends_[piece] = finer.size();
      if (is_halved[i]) finer.push_back({middle_of(all[i]), chords_[i].center, chords_[i].is_arc});
      finer.push_back(chords_[i]);
    }
    for (; piece < ends_.size(); ++piece) ends_[piece] = finer.size();
    chords_ = std::move(finer);
    return true;
  }

  std::vector<OutlineChord> chords_;
  std::vector<Vec2> starts_;       // of each piece
  std::vector<std::size_t> ends_;  // number of chords before the end of each piece
  std::size_t next_ = 0;
};

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

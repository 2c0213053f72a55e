// SPDX-License-Identifier: GPL-3.0-or-later
// Divide and conquer in the plane, for triangulations of points and of balls. The decisions are those of a kernel.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/jobs/parallel.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/kernels.h"
#include "core/structures/triangulation/point_triangulation.h"

namespace mes::point_joiner {

/// The predicates that the joiner needs from a kernel's points.
template <class Kernel>
struct JoinerSigns {
  using Point = typename Kernel::Point_2;
  static bool precedes(const Point& p, const Point& q, bool by_y) {
    return typename Kernel::Less_along()(p, q, by_y);
  }
  static int turn(const Point& p, const Point& q, const Point& r) {
    return static_cast<int>(typename Kernel::Orientation_2()(p, q, r));
  }
  /// Points have no weights, so those are ignored.
  static bool holds(const Point& a, double, const Point& b, double, const Point& c, double, const Point& d, double) {
    return typename Kernel::Side_of_oriented_circle_2()(a, b, c, d) == CGAL::ON_POSITIVE_SIDE;
  }
};
template <>
struct JoinerSigns<FastKernel> {
  using Point = FastKernel::Point_2;
  static bool precedes(const Point& p, const Point& q, bool by_y) {
    if (by_y) return p.y() != q.y() ? p.y() < q.y() : p.x() > q.x();
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  }
  static int turn(const Point& p, const Point& q, const Point& r) {
    return static_cast<int>(CGAL::orientation(p, q, r));
  }
  static bool holds(const Point& a, double wa, const Point& b, double wb, const Point& c, double wc, const Point& d,
                    double wd) {
    const auto ball = [](const Point& p, double weight) { return BallOf<double>{p.x(), p.y(), weight}; };
    return sign_of_excess_at_center<FastKernel>(ball(a, wa), ball(b, wb), ball(c, wc), ball(d, wd)) < 0;
  }
};

/// Halves of edges: 2k and 2k + 1 are the two directions of edge k.
using HalfSlot = Slot<struct HalfTag>;
/// Index of a point in the order of the pieces.
using PlaceSlot = Slot<struct PlaceTag>;

struct Half {
  PlaceSlot origin;  ///< kNoSlot if the edge is free
  HalfSlot next;     ///< next about the origin, counter-clockwise; for a free edge, the next free one
  HalfSlot before;   ///< next about the origin, clockwise
};

constexpr HalfSlot twin(HalfSlot half) {
  return HalfSlot(half.index() ^ 1U);
}
constexpr HalfSlot first_of_both(HalfSlot half) {
  return HalfSlot(half.index() & ~1U);
}

/// Triangulation of a range of points, with the data that joining needs.
struct Piece {
  HalfSlot hull;  ///< a half with nothing on its left
  HalfSlot first_free, last_free;
  std::size_t edges = 0;
  std::size_t points = 0;
};

// Divide and conquer in the plane: pieces are halved across alternating axes and joined from bottom to top.
// Source: Guibas and Stolfi, "Primitives for the manipulation of general subdivisions", 1985; the alternating axes
// Dwyer 1987. Points lie in the order of the pieces, and the edges of n points use the 3n rows of these points. So
// pieces are made in parallel, and the result depends on the points alone.
//
// For balls the same steps wrap the lower hull of the lifted points (Preparata and Hong 1977), as long as each of them
// is a corner of it. Where one is not, or where collinear points of a hull might hide one another, the joiner gives up.
template <class Kernel>
class Joiner {
  using Signs = JoinerSigns<Kernel>;

 public:
  using Point = typename Kernel::Point_2;
  struct Placed {
    Point p;
    double weight;
    InputSlot point;
  };
  Joiner(Table<PlaceSlot, Placed> points, bool is_weighted, JobControl& job)
      : is_weighted_(is_weighted), job_(job), at_(std::move(points)), halves_(6 * at_.size()) {}

  /// Triangulates two or more points; false if the joiner gave up.
  bool run();
  /// False if some face is not a triangle, which happens only when the joiner gives up too late.
  bool extract(PointTriangulation& out) const;

 private:
  struct Range {
    std::size_t begin, end;
  };

  static bool precedes(const Point& p, const Point& q, bool by_y) { return Signs::precedes(p, q, by_y); }
  static bool is_left_turn(const Point& p, const Point& q, const Point& r) { return Signs::turn(p, q, r) > 0; }
  static bool is_right_turn(const Point& p, const Point& q, const Point& r) { return Signs::turn(p, q, r) < 0; }
  static constexpr std::size_t kStrip = 16;
  auto place(std::size_t i) { return at_.begin() + static_cast<std::ptrdiff_t>(i); }
  std::size_t halve(Range range, bool by_y) {
    const std::size_t middle = range.begin + (range.end - range.begin) / 2;
    std::nth_element(place(range.begin), place(middle), place(range.end),
                     [by_y](const Placed& a, const Placed& b) { return precedes(a.p, b.p, by_y); });
    return middle;
  }
  Piece make(Range range, bool by_y);
  Piece make_strip(Range range);
  Piece make_small(Range range);
  Piece join(const Piece& low, const Piece& high, bool by_y);
  /// Hidden points could send the walk between two pieces in circles, or make more edges than there is room for.
  bool has_lost_its_way(std::size_t steps, const Piece& piece) {
    if (is_weighted_ && (steps > 3 * piece.points || piece.first_free == kNoSlot)) is_given_up_ = true;
    return is_given_up_;
  }
  bool is_convex() const;
  bool is_flat_at(HalfSlot half) const;
  /// True if the piece has as many edges as a triangulation of all its points; `sides` counts its hull edges.
  static bool holds_all(const Piece& piece, std::size_t sides) { return piece.edges + 3 + sides == 3 * piece.points; }
  /// Power test of the origins of the four halves; the first three run counter-clockwise.
  bool holds(HalfSlot a, HalfSlot b, HalfSlot c, HalfSlot d) const {
    const auto at = [this](HalfSlot half) -> const Placed& { return at_[halves_[half].origin]; };
    const Placed &p = at(a), &q = at(b), &r = at(c), &s = at(d);
    return Signs::holds(p.p, p.weight, q.p, q.weight, r.p, r.weight, s.p, s.weight);
  }

  const Point& origin(HalfSlot half) const { return at_[halves_[half].origin].p; }
  const Point& target(HalfSlot half) const { return origin(twin(half)); }
  /// Next half around the left face.
  HalfSlot following(HalfSlot half) const { return halves_[twin(half)].before; }
  HalfSlot new_edge(PlaceSlot from, PlaceSlot to, Piece& piece);
  void free_edge(HalfSlot half, Piece& piece);
  void put_after(HalfSlot half, HalfSlot place);
  /// New edge from the target of `a` to the origin of `b`, which share their left face.
  HalfSlot connect(HalfSlot a, HalfSlot b, Piece& piece);

  bool is_weighted_;
  std::atomic<bool> is_given_up_ = false;
  JobControl& job_;
  Table<PlaceSlot, Placed> at_;
  Table<HalfSlot, Half> halves_;
  Piece whole_;
};

template <class Kernel>
HalfSlot Joiner<Kernel>::new_edge(PlaceSlot from, PlaceSlot to, Piece& piece) {
  const HalfSlot half = piece.first_free;
  piece.first_free = halves_[half].next;
  if (piece.first_free == kNoSlot) piece.last_free = kNoSlot;
  halves_[half] = {from, half, half};
  halves_[twin(half)] = {to, twin(half), twin(half)};
  ++piece.edges;
  return half;
}

template <class Kernel>
void Joiner<Kernel>::free_edge(HalfSlot half, Piece& piece) {
  half = first_of_both(half);
  if (is_weighted_ && half == first_of_both(piece.hull)) is_given_up_ = true;  // no way back to the hull
  for (const HalfSlot h : {half, twin(half)}) {
    const Half& row = halves_[h];
    halves_[row.before].next = row.next;
    halves_[row.next].before = row.before;
  }
  halves_[half] = {PlaceSlot(), piece.first_free, HalfSlot()};
  halves_[twin(half)] = {};
  --piece.edges;
  piece.first_free = half;
  if (piece.last_free == kNoSlot) piece.last_free = half;
}

template <class Kernel>
void Joiner<Kernel>::put_after(HalfSlot half, HalfSlot place) {
  const HalfSlot next = halves_[place].next;
  halves_[place].next = half;
  halves_[half].before = place;
  halves_[half].next = next;
  halves_[next].before = half;
}

template <class Kernel>
HalfSlot Joiner<Kernel>::connect(HalfSlot a, HalfSlot b, Piece& piece) {
  const HalfSlot half = new_edge(halves_[twin(a)].origin, halves_[b].origin, piece);
  put_after(half, following(a));
  put_after(twin(half), b);
  return half;
}

template <class Kernel>
Piece Joiner<Kernel>::make_small(Range range) {
  Piece piece;
  piece.points = range.end - range.begin;
  for (std::size_t edge = 3 * range.begin; edge < 3 * range.end; ++edge)
    halves_[HalfSlot(2 * edge)].next = edge + 1 < 3 * range.end ? HalfSlot(2 * (edge + 1)) : HalfSlot();
  piece.first_free = HalfSlot(6 * range.begin);
  piece.last_free = HalfSlot(6 * range.end - 2);
  const PlaceSlot first(range.begin), second(range.begin + 1), third(range.begin + 2);
  const HalfSlot a = new_edge(first, second, piece);
  piece.hull = a;
  if (range.end - range.begin == 2) return piece;
  const HalfSlot b = new_edge(second, third, piece);
  put_after(b, twin(a));
  const int turn = Signs::turn(at_[first].p, at_[second].p, at_[third].p);
  if (turn == 0) {
    if (is_weighted_) is_given_up_ = true;
    return piece;
  }
  connect(b, a, piece);
  if (turn > 0) piece.hull = twin(a);
  return piece;
}

// Walks clockwise once around the hull.
template <class Kernel>
bool Joiner<Kernel>::is_convex() const {
  std::size_t first_points = 0;
  HalfSlot half = whole_.hull;
  do {
    const HalfSlot next = following(half);
    if (!is_right_turn(origin(half), target(half), target(next))) return false;
    if (precedes(target(half), origin(half), false) && precedes(target(half), target(next), false)) ++first_points;
    half = next;
  } while (half != whole_.hull);
  return first_points == 1;
}

template <class Kernel>
bool Joiner<Kernel>::is_flat_at(HalfSlot half) const {
  return Signs::turn(origin(half), target(half), target(following(half))) == 0 ||
         Signs::turn(origin(half), target(half), target(halves_[half].next)) == 0;
}

// `low` precedes `high` along the axis. A bubble rises between the two from their lower common tangent: `base` is the
// last edge made across, from high to low.
template <class Kernel>
Piece Joiner<Kernel>::join(const Piece& low, const Piece& high, bool by_y) {
  if (is_given_up_) return {};
  // The last point of `low` and the first point of `high` along the axis, found on the hulls.
  HalfSlot left = low.hull;
  std::size_t low_sides = 1;
  for (HalfSlot half = following(left); half != low.hull; half = following(half), ++low_sides)
    if (precedes(origin(left), origin(half), by_y)) left = half;
  HalfSlot right = high.hull;
  std::size_t high_sides = 1;
  for (HalfSlot half = following(right); half != high.hull; half = following(half), ++high_sides)
    if (precedes(origin(half), origin(right), by_y)) right = half;
  if (is_weighted_ && !(holds_all(low, low_sides) && holds_all(high, high_sides))) {
    is_given_up_ = true;
    return {};
  }
  right = halves_[right].next;  // now with nothing on its right
  Piece piece = low;
  if (piece.last_free == kNoSlot) {
    piece.first_free = high.first_free;
  } else {
    halves_[piece.last_free].next = high.first_free;
  }
  if (high.last_free != kNoSlot) piece.last_free = high.last_free;
  piece.edges += high.edges;
  piece.points += high.points;
  for (std::size_t steps = 0; !has_lost_its_way(steps, piece); ++steps) {
    if (is_left_turn(origin(left), target(left), origin(right))) {
      left = following(left);
    } else if (is_right_turn(origin(right), target(right), origin(left))) {
      right = halves_[twin(right)].next;
    } else {
      break;
    }
  }
  if (is_given_up_) return {};
  HalfSlot base = connect(twin(right), left, piece);
  piece.hull = base;
  const auto rises = [&](HalfSlot half) { return is_right_turn(origin(base), target(base), target(half)); };
  // Unweighted, a point that does not rise never passes `holds`.
  const auto may_replace = [&](HalfSlot half) {
    return half != base && half != twin(base) && (!is_weighted_ || rises(half));
  };
  for (std::size_t steps = 0; !has_lost_its_way(steps, piece); ++steps) {
    HalfSlot to_low = halves_[twin(base)].next;
    const bool low_rises = rises(to_low);
    if (low_rises) {
      for (HalfSlot next = halves_[to_low].next;
           may_replace(next) && holds(twin(base), base, twin(to_low), twin(next)); next = halves_[to_low].next) {
        free_edge(to_low, piece);
        to_low = next;
      }
    }
    HalfSlot to_high = halves_[base].before;
    const bool high_rises = rises(to_high);
    if (high_rises) {
      for (HalfSlot next = halves_[to_high].before;
           may_replace(next) && holds(twin(base), base, twin(to_high), twin(next)); next = halves_[to_high].before) {
        free_edge(to_high, piece);
        to_high = next;
      }
    }
    if (!low_rises && !high_rises) {
      if (is_weighted_ && (is_flat_at(piece.hull) || is_flat_at(twin(base)))) is_given_up_ = true;
      return piece;
    }
    const HalfSlot last = base;
    const bool takes_high = !low_rises || (high_rises && holds(twin(to_low), to_low, to_high, twin(to_high)));
    base = takes_high ? connect(to_high, twin(base), piece) : connect(twin(base), twin(to_low), piece);
    if (!is_weighted_) continue;
    // Edges covered by the new triangle lead to points that it hides.
    const auto is_under = [&](HalfSlot half) {
      return half != last && half != twin(last) && is_right_turn(origin(last), target(last), target(half)) &&
             !rises(half);
    };
    if (takes_high) {
      while (is_under(halves_[twin(base)].next)) free_edge(halves_[twin(base)].next, piece);
    } else {
      while (is_under(halves_[base].before)) free_edge(halves_[base].before, piece);
    }
  }
  return {};
}

// Takes points in the order of the first axis: halving a few across the other axis costs more than it saves.
template <class Kernel>
Piece Joiner<Kernel>::make_strip(Range range) {
  if (range.end - range.begin <= 3) return make_small(range);
  const std::size_t middle = range.begin + (range.end - range.begin) / 2;
  return join(make_strip({range.begin, middle}), make_strip({middle, range.end}), false);
}

template <class Kernel>
Piece Joiner<Kernel>::make(Range range, bool by_y) {
  const std::size_t count = range.end - range.begin;
  if (count <= kStrip) {
    std::sort(place(range.begin), place(range.end),
              [](const Placed& a, const Placed& b) { return precedes(a.p, b.p, false); });
    return make_strip(range);
  }
  if (is_given_up_) return {};
  if (count > 1000) job_.checkpoint();
  const std::size_t middle = halve(range, by_y);
  const Piece low = make({range.begin, middle}, !by_y);
  const Piece high = make({middle, range.end}, !by_y);
  return join(low, high, by_y);
}

template <class Kernel>
bool Joiner<Kernel>::run() {
  // Halve a few times, so that there is enough work for all cores.
  const auto levels = std::min<std::size_t>(4, static_cast<std::size_t>(std::bit_width(at_.size() >> 11U)));
  std::vector<Range> ranges{{0, at_.size()}};
  for (std::size_t level = 0; level < levels; ++level) {
    std::vector<Range> finer(2 * ranges.size());
    run_tasks(ranges.size(), [&](std::size_t i) {
      const std::size_t middle = halve(ranges[i], level % 2 != 0);
      finer[2 * i] = {ranges[i].begin, middle};
      finer[2 * i + 1] = {middle, ranges[i].end};
    });
    ranges.swap(finer);
  }
  std::vector<Piece> pieces(ranges.size());
  run_tasks(ranges.size(), [&](std::size_t i) { pieces[i] = make(ranges[i], levels % 2 != 0); });
  for (std::size_t level = levels; level-- > 0;) {
    std::vector<Piece> joined(pieces.size() / 2);
    run_tasks(joined.size(),
              [&](std::size_t i) { joined[i] = join(pieces[2 * i], pieces[2 * i + 1], level % 2 != 0); });
    pieces.swap(joined);
  }
  if (is_given_up_) return false;
  whole_ = pieces[0];
  return !is_weighted_ || is_convex();
}

template <class Kernel>
bool Joiner<Kernel>::extract(PointTriangulation& out) const {
  constexpr TriangleSlot kOutside(0xfffffffeU);
  Table<HalfSlot, TriangleSlot> face_of(halves_.size());
  HalfSlot half = whole_.hull;
  do {
    face_of[half] = kOutside;
    half = following(half);
  } while (half != whole_.hull);
  out.faces.reserve(2 * at_.size());
  Table<TriangleSlot, std::array<HalfSlot, 3>> sides;
  sides.reserve(2 * at_.size());
  for (const HalfSlot h : halves_.rows()) {
    if (halves_[h].origin == kNoSlot || face_of[h] != kNoSlot) continue;
    const TriangleSlot row = out.faces.next();
    PointTriangulation::Face& face = out.faces.emplace_back();
    std::array<HalfSlot, 3>& around = sides.emplace_back();
    HalfSlot side = h;
    for (std::size_t i = 0; i < 3; ++i) {
      face.v[i] = at_[halves_[side].origin].point;
      face_of[side] = row;
      around[i] = side;
      side = following(side);
    }
    if (side != h) return false;
  }
  out.dimension = out.faces.empty() ? 1 : 2;
  parallel_for(out.faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const TriangleSlot f : slots_between<TriangleSlot>(begin, end)) {
      for (std::size_t i = 0; i < 3; ++i) {
        // Side i leaves corner i, so it lies opposite corner i + 2.
        const TriangleSlot beyond = face_of[twin(sides[f][i])];
        out.faces[f].n[(i + 2) % 3] = beyond == kOutside ? TriangleSlot() : beyond;
      }
    }
  });
  if (out.dimension == 2) return true;
  for (const HalfSlot h : halves_.rows())
    if (h == first_of_both(h) && halves_[h].origin != kNoSlot)
      out.line.push_back({at_[halves_[h].origin].point, at_[halves_[twin(h)].origin].point});
  return true;
}

}  // namespace mes::point_joiner

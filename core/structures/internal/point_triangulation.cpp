// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/internal/point_triangulation.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/kernels.h"

namespace mes {
namespace {

using Point = FastKernel::Point_2;

/// Halves of edges: 2k and 2k + 1 are the two directions of edge k.
struct Half {
  Slot origin = kNoSlot;  ///< kNoSlot = the edge is free
  Slot next = kNoSlot;    ///< about the origin, counter-clockwise; of a free edge the next free one
  Slot before = kNoSlot;  ///< about the origin, clockwise
};

constexpr Slot twin(Slot half) {
  return half ^ 1U;
}

/// Delaunay triangulation of a range of points: what is needed to join it to another one.
struct Piece {
  Slot hull = kNoSlot;  ///< a half with nothing on its left
  Slot first_free = kNoSlot, last_free = kNoSlot;
};

// Divide and conquer in the plane: pieces are halved across alternating axes and joined from bottom to top.
// Source: Guibas and Stolfi, "Primitives for the manipulation of general subdivisions", 1985; the alternating axes
// Dwyer 1987. Points lie in the order of the pieces, and edges of n points in the 3n places that belong to them:
// pieces are made side by side, and the result depends on the points alone.
class Joiner {
 public:
  Joiner(const std::vector<Point>& points, const std::vector<Slot>& distinct, JobControl& job)
      : job_(job), halves_(6 * distinct.size()) {
    at_.reserve(distinct.size());
    for (const Slot i : distinct) at_.push_back({points[i], i});
  }

  PointTriangulation run();

 private:
  struct Placed {
    Point p;
    Slot point;
  };
  struct Range {
    std::size_t begin, end;
  };

  static bool precedes(const Point& p, const Point& q, bool by_y) {
    if (by_y) return p.y() != q.y() ? p.y() < q.y() : p.x() > q.x();
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  }
  std::size_t halve(Range range, bool by_y) {
    const auto at = [this](std::size_t i) { return at_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t middle = range.begin + (range.end - range.begin) / 2;
    std::nth_element(at(range.begin), at(middle), at(range.end),
                     [by_y](const Placed& a, const Placed& b) { return precedes(a.p, b.p, by_y); });
    return middle;
  }
  Piece make(Range range, bool by_y);
  Piece make_small(Range range);
  Piece join(const Piece& low, const Piece& high, bool by_y);
  void extract(Slot hull, PointTriangulation& out) const;

  const Point& origin(Slot half) const { return at_[halves_[half].origin].p; }
  const Point& target(Slot half) const { return origin(twin(half)); }
  /// Around the left face.
  Slot following(Slot half) const { return halves_[twin(half)].before; }
  Slot new_edge(Slot from, Slot to, Piece& piece);
  void free_edge(Slot half, Piece& piece);
  void put_after(Slot half, Slot place);
  /// From the target of `a` to the origin of `b`, which have one left face.
  Slot connect(Slot a, Slot b, Piece& piece);

  JobControl& job_;
  std::vector<Placed> at_;
  std::vector<Half> halves_;
};

Slot Joiner::new_edge(Slot from, Slot to, Piece& piece) {
  const Slot half = piece.first_free;
  piece.first_free = halves_[half].next;
  if (piece.first_free == kNoSlot) piece.last_free = kNoSlot;
  halves_[half] = {from, half, half};
  halves_[twin(half)] = {to, twin(half), twin(half)};
  return half;
}

void Joiner::free_edge(Slot half, Piece& piece) {
  half &= ~Slot{1};
  for (const Slot h : {half, twin(half)}) {
    const Half& row = halves_[h];
    halves_[row.before].next = row.next;
    halves_[row.next].before = row.before;
  }
  halves_[half] = {kNoSlot, piece.first_free, kNoSlot};
  halves_[twin(half)] = {};
  piece.first_free = half;
  if (piece.last_free == kNoSlot) piece.last_free = half;
}

void Joiner::put_after(Slot half, Slot place) {
  const Slot next = halves_[place].next;
  halves_[place].next = half;
  halves_[half].before = place;
  halves_[half].next = next;
  halves_[next].before = half;
}

Slot Joiner::connect(Slot a, Slot b, Piece& piece) {
  const Slot half = new_edge(halves_[twin(a)].origin, halves_[b].origin, piece);
  put_after(half, following(a));
  put_after(twin(half), b);
  return half;
}

Piece Joiner::make_small(Range range) {
  Piece piece;
  for (std::size_t edge = 3 * range.begin; edge < 3 * range.end; ++edge)
    halves_[2 * edge].next = edge + 1 < 3 * range.end ? static_cast<Slot>(2 * (edge + 1)) : kNoSlot;
  piece.first_free = static_cast<Slot>(6 * range.begin);
  piece.last_free = static_cast<Slot>(6 * range.end - 2);
  std::sort(at_.begin() + static_cast<std::ptrdiff_t>(range.begin),
            at_.begin() + static_cast<std::ptrdiff_t>(range.end),
            [](const Placed& a, const Placed& b) { return precedes(a.p, b.p, false); });
  const auto first = static_cast<Slot>(range.begin);
  const Slot a = new_edge(first, first + 1, piece);
  piece.hull = a;
  if (range.end - range.begin == 2) return piece;
  const Slot b = new_edge(first + 1, first + 2, piece);
  put_after(b, twin(a));
  const auto turn = CGAL::orientation(at_[first].p, at_[first + 1].p, at_[first + 2].p);
  if (turn == CGAL::COLLINEAR) return piece;
  connect(b, a, piece);
  if (turn == CGAL::LEFT_TURN) piece.hull = twin(a);
  return piece;
}

// `low` precedes `high` along the axis. A bubble rises between the two from the common tangent below: `base` is the
// edge across that was made last, from high to low.
Piece Joiner::join(const Piece& low, const Piece& high, bool by_y) {
  // The last point of the one and the first point of the other, along the hull.
  Slot left = low.hull;
  for (Slot half = following(left); half != low.hull; half = following(half))
    if (precedes(origin(left), origin(half), by_y)) left = half;
  Slot right = high.hull;
  for (Slot half = following(right); half != high.hull; half = following(half))
    if (precedes(origin(half), origin(right), by_y)) right = half;
  right = halves_[right].next;  // now with nothing on its right
  for (;;) {
    if (CGAL::left_turn(origin(left), target(left), origin(right))) {
      left = following(left);
    } else if (CGAL::right_turn(origin(right), target(right), origin(left))) {
      right = halves_[twin(right)].next;
    } else {
      break;
    }
  }
  Piece piece = low;
  if (piece.last_free == kNoSlot) {
    piece.first_free = high.first_free;
  } else {
    halves_[piece.last_free].next = high.first_free;
  }
  if (high.last_free != kNoSlot) piece.last_free = high.last_free;
  Slot base = connect(twin(right), left, piece);
  piece.hull = base;
  const auto rises = [&](Slot half) { return CGAL::right_turn(origin(base), target(base), target(half)); };
  const auto holds = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto point = [](const Point& p) { return BallOf<double>{p.x(), p.y(), 0.0}; };
    return sign_of_excess_at_center<FastKernel>(point(a), point(b), point(c), point(d)) < 0;
  };
  for (;;) {
    Slot to_low = halves_[twin(base)].next;
    const bool low_rises = rises(to_low);
    if (low_rises) {
      for (Slot next = halves_[to_low].next;
           next != twin(base) && holds(target(base), origin(base), target(to_low), target(next));
           next = halves_[to_low].next) {
        free_edge(to_low, piece);
        to_low = next;
      }
    }
    Slot to_high = halves_[base].before;
    const bool high_rises = rises(to_high);
    if (high_rises) {
      for (Slot next = halves_[to_high].before;
           next != base && holds(target(base), origin(base), target(to_high), target(next));
           next = halves_[to_high].before) {
        free_edge(to_high, piece);
        to_high = next;
      }
    }
    if (!low_rises && !high_rises) return piece;
    if (!low_rises || (high_rises && holds(target(to_low), origin(to_low), origin(to_high), target(to_high)))) {
      base = connect(to_high, twin(base), piece);
    } else {
      base = connect(twin(base), twin(to_low), piece);
    }
  }
}

Piece Joiner::make(Range range, bool by_y) {
  const std::size_t count = range.end - range.begin;
  if (count <= 3) return make_small(range);
  if (count > 1000) job_.checkpoint();
  const std::size_t middle = halve(range, by_y);
  const Piece low = make({range.begin, middle}, !by_y);
  const Piece high = make({middle, range.end}, !by_y);
  return join(low, high, by_y);
}

PointTriangulation Joiner::run() {
  // Halved a few times, so that there is enough to do side by side.
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
  PointTriangulation out;
  extract(pieces[0].hull, out);
  return out;
}

void Joiner::extract(Slot hull, PointTriangulation& out) const {
  constexpr Slot kOutside = kNoSlot - 1;
  std::vector<Slot> face_of(halves_.size(), kNoSlot);
  Slot half = hull;
  do {
    face_of[half] = kOutside;
    half = following(half);
  } while (half != hull);
  out.faces.reserve(2 * at_.size());
  std::vector<Slot> first_half;
  first_half.reserve(2 * at_.size());
  for (Slot h = 0; h < halves_.size(); ++h) {
    if (halves_[h].origin == kNoSlot || face_of[h] != kNoSlot) continue;
    PointTriangulation::Face& face = out.faces.emplace_back();
    first_half.push_back(h);
    Slot side = h;
    for (Slot& v : face.v) {
      v = at_[halves_[side].origin].point;
      face_of[side] = static_cast<Slot>(out.faces.size() - 1);
      side = following(side);
    }
  }
  out.dimension = out.faces.empty() ? 1 : 2;
  for (Slot f = 0; f < out.faces.size(); ++f) {
    // Side i leaves corner i, so it lies opposite corner i + 2.
    Slot side = first_half[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const Slot beyond = face_of[twin(side)];
      out.faces[f].n[(i + 2) % 3] = beyond == kOutside ? kNoSlot : beyond;
      side = following(side);
    }
  }
  if (out.dimension == 2) return;
  for (Slot h = 0; h < halves_.size(); h += 2)
    if (halves_[h].origin != kNoSlot)
      out.line.push_back({at_[halves_[h].origin].point, at_[halves_[twin(h)].origin].point});
}

/// The first of equal points, for each of them.
std::vector<Slot> first_of_equals(const std::vector<Point>& points) {
  std::vector<Slot> out(points.size());
  const unsigned bits = static_cast<unsigned>(std::bit_width(2 * points.size()));
  std::vector<Slot> table(std::size_t{1} << bits, kNoSlot);
  const auto key = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // the two zeros are equal
  for (Slot i = 0; i < points.size(); ++i) {
    // Multiplied by odd constants of no pattern; the high bits depend on all others.
    const std::uint64_t mixed =
        (key(points[i].x()) * 0x9e3779b97f4a7c15U) ^ (key(points[i].y()) * 0xc2b2ae3d27d4eb4fU);
    std::size_t place = (mixed * 0x9e3779b97f4a7c15U) >> (64U - bits);
    while (table[place] != kNoSlot && points[table[place]] != points[i]) place = (place + 1) & (table.size() - 1);
    if (table[place] == kNoSlot) table[place] = i;
    out[i] = table[place];
  }
  return out;
}

}  // namespace

template <>
PointTriangulation point_triangulation<FastKernel>(const std::vector<Point>& points, JobControl& job) {
  const std::vector<Slot> same_as = first_of_equals(points);
  std::vector<Slot> distinct;
  distinct.reserve(points.size());
  for (Slot i = 0; i < points.size(); ++i)
    if (same_as[i] == i) distinct.push_back(i);
  PointTriangulation out;
  if (distinct.size() > 1) {
    out = Joiner(points, distinct, job).run();
  } else {
    out.dimension = static_cast<int>(distinct.size()) - 1;
  }
  out.same_as = same_as;
  return out;
}

}  // namespace mes

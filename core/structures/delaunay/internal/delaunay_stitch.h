// SPDX-License-Identifier: GPL-3.0-or-later
// Merges two Delaunay triangulations that lie side by side.
#pragma once

#include <CGAL/enum.h>

#include "core/base/geometry/vec2.h"

namespace mes {

/// An order of the plane by distance along x or y. Ties are broken by the other coordinate, as if the direction were
/// turned left by an infinitesimal angle, so that a line can always separate two sets of which one comes before the
/// other.
struct SweepOrder {
  bool along_y = false;
  bool operator()(Vec2 a, Vec2 b) const {
    if (along_y) return a.y < b.y || (a.y == b.y && b.x < a.x);
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  }
};

/// Guarantees:
///  1. `into` becomes the Delaunay triangulation of both sets; `from` is left empty, fit for destruction only.
///  2. Finite vertices keep their handles and what is stored with them.
/// Both must be of dimension two, and every point of `into` must come before every point of `from`.
///
/// Cost: O(hull + edges that vanish or are new). How: the outsides of the two become one along the common tangent on
/// one side. That leaves an infinite face above the tangent, which climbs to the other common tangent. Each step first
/// flips edges that the next triangle's circle forbids to the outside; then it flips an infinite edge of the face,
/// which makes that triangle between the two sets. All is done by flips, so the triangulation is complete all the time.
/// Source: the merge step of Guibas and Stolfi, "Primitives for the manipulation of general subdivisions", 1985.
template <class Triangulation>
class DelaunayStitch {
  using VertexHandle = typename Triangulation::Vertex_handle;
  using FaceHandle = typename Triangulation::Face_handle;

 public:
  static void run(Triangulation& into, Triangulation& from, SweepOrder before) {
    DelaunayStitch stitch(into);
    stitch.climb(stitch.join_outsides(from, before));
  }

 private:
  explicit DelaunayStitch(Triangulation& into) : t_(into) {}

  static int ccw(int i) { return Triangulation::ccw(i); }
  static int cw(int i) { return Triangulation::cw(i); }
  // The ends of an infinite face's hull edge. With the set on the right, `first` comes before `second`.
  VertexHandle first(FaceHandle f) const { return f->vertex(ccw(f->index(infinite_))); }
  VertexHandle second(FaceHandle f) const { return f->vertex(cw(f->index(infinite_))); }
  // The infinite faces that share the infinite edge at the hull edge's end.
  FaceHandle before_first(FaceHandle f) const { return f->neighbor(cw(f->index(infinite_))); }
  FaceHandle after_second(FaceHandle f) const { return f->neighbor(ccw(f->index(infinite_))); }

  CGAL::Orientation turn(VertexHandle a, VertexHandle b, VertexHandle c) const {
    return t_.geom_traits().orientation_2_object()(a->point(), b->point(), c->point());
  }
  // True if `d` lies inside the circle through a, b, c, which turn left. CGAL's perturbation decides cocircular cases,
  // as in insertions and removals, so that the result depends on the points alone.
  bool encloses(VertexHandle a, VertexHandle b, VertexHandle c, VertexHandle d) const {
    return t_.side_of_oriented_circle(a->point(), b->point(), c->point(), d->point(), true) == CGAL::ON_POSITIVE_SIDE;
  }

  // The infinite face whose first vertex is the last of all in the order `before`.
  template <class Before>
  FaceHandle at_extreme(VertexHandle infinite, Before before) const {
    const auto point = [&](FaceHandle f) {
      const auto& p = f->vertex(ccw(f->index(infinite)))->point();
      return Vec2{p.x(), p.y()};
    };
    const FaceHandle start = infinite->face();
    FaceHandle best = start;
    for (FaceHandle f = start->neighbor(ccw(start->index(infinite))); f != start;
         f = f->neighbor(ccw(f->index(infinite))))
      if (before(point(best), point(f))) best = f;
    return best;
  }

  // Joins the two along the tangent that has both on its left, seen from `into`; returns the infinite face above it.
  FaceHandle join_outsides(Triangulation& from, SweepOrder before) {
    infinite_ = t_.infinite_vertex();
    FaceHandle after_l = at_extreme(infinite_, before);
    FaceHandle until_r = at_extreme(from.infinite_vertex(), [before](Vec2 a, Vec2 b) { return before(b, a); });
    const VertexHandle other_infinite = from.infinite_vertex();
    const FaceHandle start = until_r;
    FaceHandle f = start;
    do {
      const int i = f->index(other_infinite);
      f->set_vertex(i, infinite_);
      f = f->neighbor(ccw(i));
    } while (f != start);
    from.tds().delete_vertex(other_infinite);
    t_.tds().vertices().merge(from.tds().vertices());
    t_.tds().faces().merge(from.tds().faces());

    until_r = before_first(until_r);
    for (;;) {
      if (turn(first(after_l), second(after_l), second(until_r)) == CGAL::LEFT_TURN) {
        after_l = after_second(after_l);
      } else if (turn(second(until_r), first(until_r), first(after_l)) == CGAL::RIGHT_TURN) {
        until_r = before_first(until_r);
      } else {
        break;
      }
    }
    const FaceHandle until_l = before_first(after_l);
    const FaceHandle after_r = after_second(until_r);
    const VertexHandle l = first(after_l);
    const VertexHandle r = second(until_r);
    auto& tds = t_.tds();
    const FaceHandle above = tds.create_face(infinite_, l, r);
    const FaceHandle below = tds.create_face(infinite_, r, l);
    tds.set_adjacency(above, 0, below, 0);
    tds.set_adjacency(above, 2, until_l, ccw(until_l->index(infinite_)));
    tds.set_adjacency(above, 1, after_r, cw(after_r->index(infinite_)));
    tds.set_adjacency(below, 2, until_r, ccw(until_r->index(infinite_)));
    tds.set_adjacency(below, 1, after_l, cw(after_l->index(infinite_)));
    return above;
  }

  void climb(FaceHandle above) {
    auto& tds = t_.tds();
    for (;;) {
      const VertexHandle l = first(above);
      const VertexHandle r = second(above);
      const auto is_above = [&](VertexHandle v) { return turn(l, r, v) == CGAL::LEFT_TURN; };
      // Flip hull edges that the circle through l, r and their upper end forbids; what lies behind them comes out.
      const bool can_left = is_above(first(before_first(above)));
      while (can_left) {
        const FaceHandle f = before_first(above);
        const int i = f->index(infinite_);
        if (t_.is_infinite(f->neighbor(i)) || !encloses(l, r, first(f), tds.mirror_vertex(f, i))) break;
        tds.flip(f, i);
      }
      const bool can_right = is_above(second(after_second(above)));
      while (can_right) {
        const FaceHandle f = after_second(above);
        const int i = f->index(infinite_);
        if (t_.is_infinite(f->neighbor(i)) || !encloses(l, r, second(f), tds.mirror_vertex(f, i))) break;
        tds.flip(f, i);
      }
      if (!can_left && !can_right) return;
      const VertexHandle next_l = first(before_first(above));
      const VertexHandle next_r = second(after_second(above));
      const bool goes_right = !can_left || (can_right && encloses(next_l, l, r, next_r));
      const FaceHandle beside = goes_right ? after_second(above) : before_first(above);
      const int i = above->index(infinite_);
      tds.flip(above, goes_right ? ccw(i) : cw(i));
      if (!above->has_vertex(infinite_)) above = beside;
    }
  }

  Triangulation& t_;
  VertexHandle infinite_;
};

}  // namespace mes

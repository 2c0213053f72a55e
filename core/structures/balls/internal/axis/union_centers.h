// SPDX-License-Identifier: GPL-3.0-or-later
// The centres of balls in the Voronoi diagram of the v-points: the circle of a ball holds v-points and its interior
// none, so the centre lies on the Voronoi edge of any two that are neighbours on the circle.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/crossings/union_v_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// A ball's centre lies on a Voronoi edge; the arc lies to the left (towards face 0) or right of it.
struct CenterEvent {
  VEdgeSlot edge;
  InputSlot ball;
  std::uint8_t side = 0;
  CircleArc arc = CircleArc::free;
};

/// An arc of a ball that is given by its index in the input.
using InputArc = ArcOf<InputSlot>;

/// Results of the circles of all balls, in the order of the balls.
struct CenterTables {
  std::vector<CenterEvent> events;
  Table<VFaceSlot, InputSlot> ball_of_face;  ///< ball whose centre is the face's circumcentre; kNoSlot = none
  std::vector<InputArc> arcs;
  std::int64_t lost_crossings = 0;  ///< see `UnionCounts`
};

/// Takes a range of balls, one after the other; holds the work space for one ball.
class CenterFinder {
 public:
  explicit CenterFinder(const VTriangulation& v) : v_(&v) {}

  std::vector<InputArc> arcs;  ///< for the caller to fill in

  /// Takes the v-points on the circle of a ball, counter-clockwise.
  void take(InputSlot ball, const std::vector<CirclePlace>& places) {
    if (places.size() < 2) return;
    for (std::size_t k = 0; k < places.size(); ++k)
      add_event(ball, places[(k + places.size() - 1) % places.size()].v, places[k].v, places[k].before);
    if (!v_->is_flat && places.size() >= 3) mark_polygon(ball, places);
  }

  template <class Balls, class Points>
  void append_to(CenterTables& out, const UnionBalls<Balls, Points>& balls) const {
    out.events.insert(out.events.end(), events_.begin(), events_.end());
    out.arcs.insert(out.arcs.end(), arcs.begin(), arcs.end());
    out.lost_crossings += lost_crossings_;
    for (const auto& [face, ball] : on_circle_) {
      // Rounding may put a triangle on two circles; which one takes it must not depend on the order.
      InputSlot& owner = out.ball_of_face[face];
      if (owner == kNoSlot || balls.comes_before(ball, owner)) owner = ball;
    }
  }
  std::size_t event_count() const { return events_.size(); }

 private:
  struct OnCircle {
    VFaceSlot face;
    InputSlot ball;
  };

  void add_event(InputSlot ball, VPointSlot from, VPointSlot to, CircleArc arc) {
    const VEdgeSlot edge = v_->edge_between(from, to);
    if (edge == kNoSlot) {
      ++lost_crossings_;
      return;
    }
    // The arc runs from `from` to `to`, to the right of the straight line.
    const std::uint8_t side = v_->edges[edge].v[0] == from ? 1 : 0;
    events_.push_back({edge, ball, side, arc});
  }

  // All triangles between the v-points of one circle have its centre as circumcentre.
  void mark_polygon(InputSlot ball, const std::vector<CirclePlace>& places) {
    point_stamp_.resize(v_->edges_begin.size() - 1, 0);
    face_stamp_.resize(v_->faces.size(), 0);
    const std::uint32_t now = ++now_;
    for (const CirclePlace& place : places) point_stamp_[place.v] = now;
    stack_.clear();
    const auto visit = [&](VFaceSlot face) {
      if (face == kNoSlot || face_stamp_[face] == now) return;
      for (const VPointSlot v : v_->faces[face])
        if (point_stamp_[v] != now) return;
      face_stamp_[face] = now;
      on_circle_.push_back({face, ball});
      stack_.push_back(face);
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
      const VEdgeSlot edge = v_->edge_between(places[k].v, places[(k + 1) % places.size()].v);
      if (edge == kNoSlot) continue;
      for (const VFaceSlot face : v_->edges[edge].f) visit(face);
    }
    while (!stack_.empty()) {
      const VFaceSlot at = stack_.back();
      stack_.pop_back();
      for (const VEdgeSlot edge : v_->face_edge[at])
        for (const VFaceSlot face : v_->edges[edge].f) visit(face);
    }
  }

  const VTriangulation* v_;
  std::vector<CenterEvent> events_;
  std::vector<OnCircle> on_circle_;
  std::int64_t lost_crossings_ = 0;
  std::vector<VFaceSlot> stack_;
  Table<VPointSlot, std::uint32_t> point_stamp_;  // stamps for the current circle
  Table<VFaceSlot, std::uint32_t> face_stamp_;
  std::uint32_t now_ = 0;
};

/// Calls `look(ball, finder)` for every ball, in parallel; `make_look()` gives each thread its own.
template <class Balls, class Points, class MakeLook>
CenterTables find_centers(const UnionBalls<Balls, Points>& balls, const VTriangulation& v, JobControl& job,
                          MakeLook make_look) {
  std::vector<CenterFinder> parts(balls.part_count(balls.size()), CenterFinder(v));
  balls.in_parts(balls.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    auto look = make_look();
    for (const InputSlot ball : slots_between<InputSlot>(begin, end)) {
      if ((ball.index() & 0x3fU) == 0) job.checkpoint(ball.index() - begin, end - begin);
      look(ball, parts[part]);
    }
  });
  CenterTables out;
  std::size_t events = 0;
  std::size_t arcs = 0;
  for (const CenterFinder& part : parts) {
    events += part.event_count();
    arcs += part.arcs.size();
  }
  out.events.reserve(events);
  out.arcs.reserve(arcs);
  out.ball_of_face.assign(v.faces.size(), kNoSlot);
  for (const CenterFinder& part : parts) part.append_to(out, balls);
  return out;
}

/// Finds the centres from v-points that are known beforehand.
template <class Balls, class Points>
CenterTables known_centers(const UnionBalls<Balls, Points>& balls, const VTriangulation& v, const KnownVPoints& known,
                           JobControl& job) {
  return find_centers(balls, v, job, [&known] {
    return [&known](InputSlot ball, CenterFinder& finder) { finder.take(ball, known.places[ball]); };
  });
}

}  // namespace mes

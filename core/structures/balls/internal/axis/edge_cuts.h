// SPDX-License-Identifier: GPL-3.0-or-later
// Sixth stage of the union pipeline: cuts the Voronoi edges of the v-points at the centres of balls on them, and
// decides which of the cuts lie in the dual complex |R|. The boundary of |R| is met at such centres only. The arc of
// the ball's circle labels the cut towards it; cuts between are labelled from their ends, as every part of |R| reaches
// a centre. No point is located.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/structures/balls/internal/axis/union_centers.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/crossings/union_v_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// Position of a cut: outside |R|, along a singular dual edge, or in |R|. In doubles the two ends of a cut may
/// contradict each other; then the greater label counts.
enum class CutLabel : std::uint8_t { unknown, out, singular, in };

/// A part of a Voronoi edge, from its left face to its right one.
struct EdgeCut {
  VEdgeSlot edge;
  InputSlot end[2];  ///< balls, or kNoSlot for the end of the Voronoi edge
  CutLabel label;

  /// The face whose circumcentre is end i; kNoSlot if the end is a ball's centre, or the cut is unbounded.
  VFaceSlot face_at(const VTriangulation& v, std::size_t i) const {
    return end[i] == kNoSlot ? v.edges[edge].f[i] : VFaceSlot();
  }
};

struct EdgeCuts {
  std::vector<EdgeCut> cuts;         ///< sorted by edge
  std::vector<std::uint32_t> begin;  ///< start of each edge, and the end of all
  Table<VEdgeSlot, VEdgeKind> kind;
  Table<VFaceSlot, std::uint8_t> is_inside;  ///< its circumcentre lies in |R|
  std::int64_t contradictions = 0;           ///< see `UnionCounts`
};

/// Cuts edges one by one, and labels each cut from its ends.
template <class Balls, class Points>
class EdgeCutter {
 public:
  EdgeCutter(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points, const VTriangulation& v)
      : balls_(balls), points_(points), v_(v) {}

  std::int64_t contradictions = 0;

  std::size_t cut_count(std::span<const CenterEvent> events) {
    list_balls(events);
    return on_edge_.size() + 1;
  }
  void cut(VEdgeSlot edge, std::span<const CenterEvent> events, VEdgeKind& kind, EdgeCut* out) {
    kind = kind_of(events);
    list_balls(events);
    if (on_edge_.size() > 1) sort_along(v_.edges[edge]);
    for (std::size_t k = 0; k <= on_edge_.size(); ++k) {
      const InputSlot a = k == 0 ? InputSlot() : on_edge_[k - 1];
      const InputSlot b = k == on_edge_.size() ? InputSlot() : on_edge_[k];
      const CutLabel from_a = a == kNoSlot ? CutLabel::unknown : label_towards(events, a, 1);
      const CutLabel from_b = b == kNoSlot ? CutLabel::unknown : label_towards(events, b, 0);
      if (from_a != CutLabel::unknown && from_b != CutLabel::unknown && from_a != from_b) ++contradictions;
      out[k] = {edge, {a, b}, std::max(from_a, from_b)};
    }
  }

 private:
  static VEdgeKind kind_of(std::span<const CenterEvent> events) {
    for (const CenterEvent& event : events)
      if (event.arc == CircleArc::singular) return VEdgeKind::alpha;
    return events.empty() ? VEdgeKind::plain : VEdgeKind::crossing;
  }
  static CutLabel label_towards(std::span<const CenterEvent> events, InputSlot ball, std::uint8_t side) {
    CutLabel label = CutLabel::unknown;
    for (const CenterEvent& event : events)
      if (event.ball == ball && event.side == side) label = std::max(label, label_of(event.arc));
    return label;
  }
  static CutLabel label_of(CircleArc arc) {
    if (arc == CircleArc::covered) return CutLabel::in;
    return arc == CircleArc::free ? CutLabel::out : CutLabel::singular;
  }
  void list_balls(std::span<const CenterEvent> events) {
    on_edge_.clear();
    for (const CenterEvent& event : events)
      if (std::ranges::find(on_edge_, event.ball) == on_edge_.end()) on_edge_.push_back(event.ball);
  }
  void sort_along(const VEdge& edge) {
    using Point = typename Points::Point_2;
    const Point p = points_.point(edge.v[0]);
    const Point q = points_.point(edge.v[1]);
    std::ranges::sort(on_edge_, [&](InputSlot a, InputSlot b) {
      const int order = compare_distances(p, q, a, b);
      return order > 0 || (order == 0 && balls_.comes_before(a, b));
    });
  }
  // Sign of the signed distance of the first centre from the line pq, less that of the second.
  int compare_distances(const typename Points::Point_2& p, const typename Points::Point_2& q, InputSlot a,
                        InputSlot b) const {
    if constexpr (kAreCrossings<Points>) {
      return compare_distances_to_line(p, q, balls_.input[a], balls_.input[b]);
    } else {
      const auto center = [&](InputSlot ball) {
        return typename Points::Point_2(balls_.in_points[ball].x, balls_.in_points[ball].y);
      };
      return typename Points::Compare_signed_distance_to_line_2()(p, q, center(a), center(b));
    }
  }

  const UnionBalls<Balls, Points>& balls_;
  const VPoints<Points>& points_;
  const VTriangulation& v_;
  std::vector<InputSlot> on_edge_;
};

/// Sorts stably; O(events + edges). Returns where the events of each edge begin.
inline std::vector<std::uint32_t> sort_by_edge(std::vector<CenterEvent>& events, std::size_t edges) {
  std::vector<std::uint32_t> begin(edges + 1, 0);
  for (const CenterEvent& event : events) ++begin[event.edge.index()];
  std::uint32_t end = 0;
  for (std::uint32_t& place : begin) place = end += place;
  std::vector<CenterEvent> sorted(events.size());
  for (std::size_t i = events.size(); i-- > 0;) sorted[--begin[events[i].edge.index()]] = events[i];
  events.swap(sorted);
  return begin;
}

/// A cut that is in |R| at one end is so up to the next centre, through all faces on the way. Fills in `is_inside` and
/// the labels that are not yet known.
inline void spread_labels(const VTriangulation& v, const Table<VFaceSlot, InputSlot>& ball_of_face, EdgeCuts& out) {
  out.is_inside.resize(v.faces.size());
  for (const VFaceSlot face : v.faces.rows()) out.is_inside[face] = ball_of_face[face] != kNoSlot ? 1 : 0;
  std::vector<VFaceSlot> stack;
  const auto settle = [&](const EdgeCut& cut) {
    for (std::size_t i = 0; i < 2; ++i) {
      const VFaceSlot face = cut.face_at(v, i);
      if (face == kNoSlot || out.is_inside[face] != 0) continue;
      out.is_inside[face] = 1;
      stack.push_back(face);
    }
  };
  for (const EdgeCut& seed : out.cuts) {
    if (seed.label != CutLabel::in) continue;
    settle(seed);
    while (!stack.empty()) {
      const VFaceSlot face = stack.back();
      stack.pop_back();
      for (const VEdgeSlot e : v.face_edge[face]) {
        EdgeCut& cut =
            out.cuts[v.edges[e].f[0] == face ? out.begin[e.index()] : out.begin[e.index() + std::size_t{1}] - 1];
        if (cut.label == CutLabel::out) ++out.contradictions;
        if (cut.label == CutLabel::unknown) cut.label = CutLabel::in;
        settle(cut);
      }
    }
  }
}

/// O(edges + events).
template <class Balls, class Points>
EdgeCuts cut_edges(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points, const VTriangulation& v,
                   std::vector<CenterEvent> events, const Table<VFaceSlot, InputSlot>& ball_of_face) {
  EdgeCuts out;
  const std::size_t edges = v.edges.size();
  const std::vector<std::uint32_t> events_begin = sort_by_edge(events, edges);
  const auto events_of = [&](std::size_t e) {
    return std::span<const CenterEvent>(events).subspan(events_begin[e], events_begin[e + 1] - events_begin[e]);
  };
  std::vector<EdgeCutter<Balls, Points>> parts(balls.part_count(edges), {balls, points, v});
  out.begin.assign(edges + 1, 0);
  balls.in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t e = begin; e < end; ++e)
      out.begin[e + 1] = static_cast<std::uint32_t>(parts[part].cut_count(events_of(e)));
  });
  for (std::size_t e = 0; e < edges; ++e) out.begin[e + 1] += out.begin[e];
  out.cuts.resize(out.begin[edges]);
  out.kind.resize(edges);
  balls.in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (const VEdgeSlot e : slots_between<VEdgeSlot>(begin, end))
      parts[part].cut(e, events_of(e.index()), out.kind[e], &out.cuts[out.begin[e.index()]]);
  });
  for (const auto& part : parts) out.contradictions += part.contradictions;
  spread_labels(v, ball_of_face, out);
  return out;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of polygon_axis.cpp: sides of the polygon, and the pieces of its axis from the segment Delaunay graph.
#pragma once

#include <mesecina/experiment.h>

#include <CGAL/Mpzf.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <ranges>
#include <utility>

using namespace mesecina;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Place = Kernel::Point_2;
using Vector = Kernel::Vector_2;
/// The ends of sides in lexicographic order. 1: who crosses the side changes between inside and outside.
using Sides = std::map<std::pair<Place, Place>, bool>;
/// Sides that only meet at corners need no divisions, which makes exact decisions several times faster.
using MeetingAtCorners =
    CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel, CGAL::Field_with_sqrt_tag,
                                                                         CGAL::Simple_cartesian<CGAL::Mpzf>,
                                                                         CGAL::Integral_domain_without_division_tag>;
using Crossing = CGAL::Segment_Delaunay_graph_filtered_traits_2<Kernel>;

double length(Vector v) {
  return std::sqrt(v.squared_length());
}
/// A straight piece, or a chord of an arc. `from` is lexicographically before `to`, whichever way it was found.
struct Piece {
  Point from, to;
  double half_angle;
  bool is_curved;
};

/// Two contours may have a side in common, which then does not bound the inside. Sides may cross if contours are not
/// made of Delaunay edges.
Sides find_sides(const Inputs& inputs, double unit, bool& may_cross) {
  Sides sides;
  const auto place = inputs.column<Point>("delaunay/sites/position");
  const auto add = [&](Row from, Row to) {
    const Place a(place[from].x / unit, place[from].y / unit), b(place[to].x / unit, place[to].y / unit);
    if (a != b) sides[std::minmax({a, b})] ^= true;
  };
  const auto site = inputs.column<Row>("delaunay/samples/site");
  const auto link = inputs.column<std::array<Row, 2>>("contours/links/samples");
  const auto is_in_contour = inputs.column<bool>("contours/links/is_closed");
  for (const Row row : inputs.live_rows("contours/links"))
    if (is_in_contour[row]) add(site[link[row][0]], site[link[row][1]]);
  const Sides contours = std::exchange(sides, {});
  const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
  if (!contours.empty()) {
    // Delaunay edges do not cross.
    for (const Row edge : inputs.live_rows("delaunay/edges")) add(ends[edge][0], ends[edge][1]);
    may_cross =
        !std::ranges::all_of(std::views::keys(contours), [&](const auto& side) { return sides.contains(side); });
    return contours;
  }
  const auto chain = inputs.column<Row>("curve/edges/chain");
  const auto is_loop = inputs.column<bool>("curve/chains/is_closed");
  for (const Row edge : inputs.live_rows("delaunay/edges"))
    if (chain[edge] != kNoRow && is_loop[chain[edge]]) add(ends[edge][0], ends[edge][1]);
  return sides;
}

/// Adds the pieces of the axis.
template <class Traits>
struct Axis {
  using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;
  using Site = typename Graph::Site_2;
  using Face = typename Graph::Face_handle;
  using Vertex = typename Graph::Vertex_handle;

  std::vector<Piece>& pieces;
  std::int64_t &lines, &arcs;

  /// Returns false if the inside is not known.
  bool compute(const Sides& sides, double unit) {
    Graph graph;
    const auto ends = std::views::keys(sides);
    graph.insert_segments(ends.begin(), ends.end());
    const std::map<Face, bool> inside = find_inside(graph, sides);
    CGAL::Bbox_2 box;
    for (const auto& [a, b] : ends) box += a.bbox() + b.bbox();
    const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    for (auto edge = graph.finite_edges_begin(); edge != graph.finite_edges_end(); ++edge) {
      auto found = inside.find(edge->first);
      if (found == inside.end()) found = inside.find(edge->first->neighbor(edge->second));
      if (found != inside.end() && found->second) add_edge(graph, *edge, unit, 1e-4 * diagonal);
    }
    return !inside.empty();
  }

  /// From a point to the nearest one of a corner or a side.
  static Vector way_to(const Site& site, Place from) {
    if (site.is_point()) return site.point() - from;
    const Place a = site.segment().source();
    const Vector side = site.segment().target() - a;
    return a + std::clamp((from - a) * side / std::max(side.squared_length(), 1e-300), 0.0, 1.0) * side - from;
  }

  static bool is_side_and_its_end(const Graph& graph, Vertex a, Vertex b) {
    if (graph.is_infinite(a) || graph.is_infinite(b) || a->is_point() == b->is_point()) return false;
    const auto equal = graph.geom_traits().equal_2_object();
    const Site side = (a->is_point() ? b : a)->site(), end = (a->is_point() ? a : b)->site();
    return equal(side.source_site(), end) || equal(side.target_site(), end);
  }
  /// The corner of two sides, if these are the three sites of a face: then the Voronoi vertex is the corner.
  static std::optional<Place> corner_of(const Graph& graph, Face face) {
    for (int i = 0; i < 3; ++i)
      if (!graph.is_infinite(face->vertex(i)) && face->vertex(i)->is_point() &&
          is_side_and_its_end(graph, face->vertex(i), face->vertex(Graph::cw(i))) &&
          is_side_and_its_end(graph, face->vertex(i), face->vertex(Graph::ccw(i))))
        return face->vertex(i)->site().point();
    return {};
  }

  /// Decides for each Voronoi vertex other than a corner whether it is inside; empty if sides do not separate regions.
  static std::map<Face, bool> find_inside(const Graph& graph, const Sides& sides) {
    std::map<Face, std::vector<std::pair<Face, bool>>> across;
    // Around a side, the edges to its two ends separate the faces on the left from those on the right.
    for (auto side = graph.finite_vertices_begin(); side != graph.finite_vertices_end(); ++side) {
      if (side->is_point()) continue;
      std::array<Face, 2> beside{};
      std::size_t half = 0;
      auto face = graph.incident_faces(side);
      const auto first = face;
      do {
        if (!corner_of(graph, face)) beside[half % 2] = face;
        if (is_side_and_its_end(graph, side, face->vertex(Graph::cw(face->index(side))))) ++half;
      } while (++face != first);
      if (half != 2 || beside[0] == Face() || beside[1] == Face()) return {};
      const Site site = side->site();
      const auto whole =
          sides.find(std::minmax({site.source_of_supporting_site(), site.target_of_supporting_site()}));
      const bool is_other = whole == sides.end() || whole->second;  // a side that a corner cuts in two is not found
      across[beside[0]].emplace_back(beside[1], is_other);
      across[beside[1]].emplace_back(beside[0], is_other);
    }
    std::map<Face, bool> inside;
    std::vector<Face> next;
    for (auto face = graph.all_faces_begin(); face != graph.all_faces_end(); ++face)
      if (graph.is_infinite(face)) inside[face] = false, next.push_back(face);
    while (!next.empty()) {
      const Face face = next.back();
      next.pop_back();
      std::vector<std::pair<Face, bool>> ways = across[face];
      for (int i = 0; i < 3; ++i)
        if (!is_side_and_its_end(graph, face->vertex(Graph::cw(i)), face->vertex(Graph::ccw(i))))
          ways.emplace_back(face->neighbor(i), false);
      for (const auto& [to, is_other] : ways) {
        if (corner_of(graph, to)) continue;
        const auto [found, is_new] = inside.try_emplace(to, inside[face] != is_other);
        if (is_new) next.push_back(to);
        if (found->second != (inside[face] != is_other)) return {};
      }
    }
    return inside;
  }

  void add_edge(const Graph& graph, const typename Graph::Edge& edge, double unit, double tolerance) {
    const Vertex p = edge.first->vertex(Graph::ccw(edge.second)), q = edge.first->vertex(Graph::cw(edge.second));
    const Vertex r = edge.first->vertex(edge.second), s = graph.tds().mirror_vertex(edge.first, edge.second);
    const auto has_length_zero = graph.geom_traits().is_degenerate_edge_2_object();
    if (is_side_and_its_end(graph, p, q) || has_length_zero(p->site(), q->site(), r->site(), s->site())) return;
    Site a = p->site(), b = q->site();
    if (a.is_segment()) std::swap(a, b);
    std::array<Place, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
      const Face face = i == 0 ? edge.first : edge.first->neighbor(edge.second);
      const std::optional<Place> corner = corner_of(graph, face);
      ends[i] = corner ? *corner : graph.circumcenter(face);
    }
    std::ranges::sort(ends);
    const bool is_arc = a.is_point() && b.is_segment();
    (is_arc ? arcs : lines) += 1;
    const auto add = [&](Place from, Place to) {
      if (to < from) std::swap(from, to);
      const Place middle = CGAL::midpoint(from, to);
      const Vector u = way_to(a, middle), v = way_to(b, middle);
      pieces.push_back({{unit * from.x(), unit * from.y()},
                        {unit * to.x(), unit * to.y()},
                        90.0 / std::numbers::pi * std::atan2(std::abs(CGAL::determinant(u, v)), u * v),
                        is_arc});
    };
    if (!is_arc) return add(ends[0], ends[1]);
    // With the origin at the foot of the corner on the side, the parabola is y = (x^2 + h^2) / 2h. A chord over a
    // width w is at most w^2 / 8h away from it.
    const Place start = b.segment().source();
    const Vector side = b.segment().target() - start, along = side / length(side);
    const Place foot = start + (a.point() - start) * along * along;
    const double h = length(a.point() - foot), first = (ends[0] - foot) * along, last = (ends[1] - foot) * along;
    const int count = static_cast<int>(std::min(std::abs(last - first) / std::sqrt(8.0 * h * tolerance), 500.0)) + 1;
    for (int i = 1; i <= count; ++i) {
      const double x = first + (last - first) * i / count;
      const Place at = i == count ? ends[1] : foot + x * along + 0.5 * (x / h * (x / h) + 1.0) * (a.point() - foot);
      add(ends[0], at);
      ends[0] = at;
    }
  }
};

}  // namespace

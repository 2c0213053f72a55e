// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/state_of_graph.h"

#include <fmt/core.h>
#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

#include "core/structures/axis/medial_axis.h"
#include "core/structures/crust/curve.h"
#include "core/structures/inputs/user_balls.h"
#include "core/structures/poles/poles.h"

namespace mes::test {
namespace {

bool less(Vec2 a, Vec2 b) {
  return lexicographically_less(a, b);
}
bool less_list(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
}

std::vector<NodeStateOf> nodes_of(const Delaunay& delaunay, const OneStepCrust& crust, const Labels& labels,
                                  const InnerBalls& balls, const MedialAxis& axis) {
  std::vector<NodeStateOf> nodes;
  Table<FaceSlot, bool> seen(delaunay.face_rows(), false);
  for (const FaceSlot seed : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(seed) || seen[seed]) continue;
    NodeStateOf node;
    node.inside = labels.is_inside(seed);
    std::vector<FaceSlot> stack{seed};
    seen[seed] = true;
    while (!stack.empty()) {
      const FaceSlot face = stack.back();
      stack.pop_back();
      const FaceRow& row = delaunay.face(face);
      if (axis.is_node(face)) node.degree += axis.node_degree(face);
      if (balls.ball(face) != balls.ball(seed) || labels.is_inside(face) != node.inside) node.degree = -1000;
      for (int i = 0; i < 3; ++i) {
        node.corners.push_back(delaunay.site_position(row.v[i]));
        if (row.e[i] == kNoSlot || !crust.is_cocircular(row.e[i]) || seen[row.n[i]]) continue;
        seen[row.n[i]] = true;
        stack.push_back(row.n[i]);
      }
    }
    std::ranges::sort(node.corners, less);
    node.corners.erase(std::unique(node.corners.begin(), node.corners.end()), node.corners.end());
    nodes.push_back(std::move(node));
  }
  std::ranges::sort(nodes,
                    [](const NodeStateOf& a, const NodeStateOf& b) { return less_list(a.corners, b.corners); });
  return nodes;
}

// Each site with the samples on its two polar circles; a pole at infinity counts as the site, a missing one as nothing.
std::vector<std::vector<Vec2>> poles_of(const Delaunay& delaunay, const VoronoiVertices& vertices,
                                        const Poles& poles) {
  std::vector<std::vector<Vec2>> out;
  std::vector<SiteSlot> sites;
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    const Vec2 p = delaunay.site_position(site);
    out.push_back({p});
    for (const FaceSlot pole : {poles.plus(site), poles.minus(site)}) {
      out.back().push_back(p);
      if (pole == kNoSlot || pole == kInfinitePole) continue;
      // A row that counts as a pole must be marked as one, and name the circle by its own canonical vertex.
      if (!poles.is_pole(pole) || vertices.vertex(pole) != pole) out.back().push_back({1e99, 1e99});
      sites.clear();
      vertices.append_sites(pole, sites);
      std::vector<Vec2> circle;
      for (const SiteSlot other : sites) circle.push_back(delaunay.site_position(other));
      std::ranges::sort(circle, less);
      out.back().insert(out.back().end(), circle.begin(), circle.end());
    }
  }
  std::ranges::sort(out, less_list);
  return out;
}

std::string text(Vec2 p) {
  std::ostringstream out;
  out.precision(17);
  out << '(' << p.x << ", " << p.y << ')';
  return out.str();
}

template <class List>
bool differ(const char* what, const List& a, const List& b, std::string& out) {
  if (a == b) return false;
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
  out = fmt::format("{} differ: {} against {}, first at {}", what, a.size(), b.size(), at);
  return true;
}

}  // namespace

bool operator<(const EdgeState& x, const EdgeState& y) {
  if (x.a != y.a) return less(x.a, y.a);
  return less(x.b, y.b);
}

GeometryState state_of(const Graph& graph) {
  const auto& delaunay = graph.structures().get<Delaunay>();
  const auto& crust = graph.structures().get<OneStepCrust>();
  const auto& labels = graph.structures().get<Labels>();
  const auto& balls = graph.structures().get<InnerBalls>();
  const auto& axis = graph.structures().get<MedialAxis>();
  const auto& curve = graph.structures().get<Curve>();
  GeometryState state;
  state.dimension = delaunay.dimension();
  const auto& own = graph.structures().get<UserBalls>();
  for (const BallSlot row : slots_below<BallSlot>(own.row_count()))
    if (own.is_alive(row))
      state.balls.push_back({own.disk(row).center.x, own.disk(row).center.y, own.disk(row).radius});
  std::ranges::sort(state.balls);
  state.odd = crust.odd_count();
  state.lone = crust.lone_count();
  state.conflicts = labels.conflict_count();
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    const Vec2 p = delaunay.site_position(site);
    state.sites.push_back(p);
    if (curve.has_normal(site)) state.normals.push_back({p.x, p.y, curve.normal(site).x, curve.normal(site).y});
  }
  std::ranges::sort(state.sites, less);
  std::ranges::sort(state.normals);
  for (const EdgeSlot e : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(e);
    if (!row.is_alive() || crust.is_cocircular(e)) continue;
    EdgeState edge{delaunay.site_position(row.v[0]),
                   delaunay.site_position(row.v[1]),
                   crust.is_crust(e),
                   labels.is_conflict(e),
                   false,
                   false};
    if (row.f[0] != kNoSlot) {
      edge.inside_left = labels.is_inside(row.f[0]);
      edge.inside_right = labels.is_inside(row.f[1]);
    }
    if (less(edge.b, edge.a)) {
      std::swap(edge.a, edge.b);
      std::swap(edge.inside_left, edge.inside_right);
    }
    state.edges.push_back(edge);
  }
  std::sort(state.edges.begin(), state.edges.end());
  if (state.dimension == 2)
    state.poles = poles_of(delaunay, graph.structures().get<VoronoiVertices>(), graph.structures().get<Poles>());
  if (state.dimension == 2) state.nodes = nodes_of(delaunay, crust, labels, balls, axis);
  for (const Curve::Chain& chain : curve.chains()) {
    if (chain.sites.empty()) continue;
    std::vector<Vec2> points;
    for (const SiteSlot site : chain.sites) points.push_back(delaunay.site_position(site));
    if (chain.closed) points.push_back(points.front());
    state.chains.push_back(std::move(points));
  }
  std::ranges::sort(state.chains, less_list);
  return state;
}

std::string difference(const GeometryState& a, const GeometryState& b) {
  std::string out;
  if (a.dimension != b.dimension) return fmt::format("dimension {} {}", a.dimension, b.dimension);
  if (differ("sites", a.sites, b.sites, out)) return out;
  if (differ("edges", a.edges, b.edges, out)) {
    for (std::size_t i = 0; i < std::min(a.edges.size(), b.edges.size()); ++i) {
      if (a.edges[i] == b.edges[i]) continue;
      const auto say = [](const EdgeState& e) {
        return fmt::format("{}{} crust {:d} conflict {:d} in {:d}{:d}", text(e.a), text(e.b), e.crust, e.conflict,
                           e.inside_left, e.inside_right);
      };
      return fmt::format("{}: {} / {}", out, say(a.edges[i]), say(b.edges[i]));
    }
    return out;
  }
  if (differ("nodes", a.nodes, b.nodes, out) || differ("chains", a.chains, b.chains, out) ||
      differ("normals", a.normals, b.normals, out) || differ("balls", a.balls, b.balls, out) ||
      differ("poles", a.poles, b.poles, out))
    return out;
  if (a.odd != b.odd) return fmt::format("odd samples {} {}", a.odd, b.odd);
  if (a.lone != b.lone) return fmt::format("samples on no curve {} {}", a.lone, b.lone);
  if (a.conflicts != b.conflicts) return fmt::format("conflict counts {} {}", a.conflicts, b.conflicts);
  return {};
}

std::string broken_row(const Graph& graph) {
  const auto& delaunay = graph.structures().get<Delaunay>();
  const auto& samples = graph.structures().get<Samples>();
  const auto& crust = graph.structures().get<OneStepCrust>();
  const auto& labels = graph.structures().get<Labels>();
  for (const SampleSlot sample : slots_below<SampleSlot>(samples.row_count())) {
    const SiteSlot site = delaunay.site_of_sample(sample);
    if (!samples.is_alive(sample)) {
      if (site != kNoSlot) return "a dead sample has a site";
      continue;
    }
    if (site == kNoSlot || !delaunay.is_site(site)) return "a sample has no site";
    if (delaunay.site_position(site) != samples.position(sample)) return "a sample is not where its site is";
    bool listed = false;
    for (SampleSlot s = delaunay.site_sample(site); s != kNoSlot; s = delaunay.next_duplicate(s))
      listed = listed || s == sample;
    if (!listed) return "a site does not list its sample";
  }
  if (delaunay.dimension() != 2) return {};
  for (const FaceSlot f : delaunay.face_slots()) {
    const FaceRow& row = delaunay.face(f);
    if (!row.is_alive()) continue;
    for (int i = 0; i < 3; ++i) {
      if (row.v[i] != kInfiniteSite && !delaunay.is_site(row.v[i])) return "a face has a dead corner";
      const FaceRow& other = delaunay.face(row.n[i]);
      if (!other.is_alive()) return "a face has a dead neighbour";
      int j = 0;
      while (j < 3 && other.n[j] != f) ++j;
      if (j == 3 || other.e[j] != row.e[i]) return "two faces disagree about what is between them";
      if (other.v[next3(j)] != row.v[prev3(i)]) return "two faces disagree about their common corners";
      const bool infinite = row.v[next3(i)] == kInfiniteSite || row.v[prev3(i)] == kInfiniteSite;
      if (infinite != (row.e[i] == kNoSlot)) return "an edge row is missing or too much";
      if (infinite) continue;
      const EdgeRow& edge = delaunay.edge(row.e[i]);
      const int side = edge.f[0] == f ? 0 : 1;
      if (edge.f[side] != f || edge.v[side] != row.v[next3(i)] || edge.v[1 - side] != row.v[prev3(i)])
        return "an edge row does not fit its face";
      const bool bit = ((crust.wall_bits_of_face(f) >> i) & 1) != 0;
      if (bit != crust.is_wall(row.e[i])) return "a face's bits of walls do not fit its edges";
      const bool border = crust.is_wall(row.e[i]) != labels.is_conflict(row.e[i]);
      if ((labels.is_inside(f) != labels.is_inside(row.n[i])) != border) return "labels contradict an edge";
    }
    if (row.is_infinite() && labels.is_inside(f)) return "a face at infinity is inside";
  }
  for (const EdgeSlot e : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(e);
    if (row.is_alive() && (delaunay.face(row.f[0]).e[delaunay.face(row.f[0]).index_of_edge(e)] != e))
      return "an edge row has no face";
  }
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    const FaceRow& row = delaunay.face(delaunay.site_face(site));
    if (!row.is_alive() || row.v[row.index_of_site(site)] != site) return "a site's face does not hold it";
  }
  return {};
}

}  // namespace mes::test

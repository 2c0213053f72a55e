// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/segment_voronoi.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/geometry/box2.h"
#include "core/structures/outline/internal/near_feature.h"
#include "core/structures/triangulation/hilbert.h"

namespace mes {
namespace {

// Sides meet at their ends only, so no kernel has to construct crossings. Where doubles do not decide, numbers without
// division do, an order of magnitude faster than rationals.
using Doubles = CGAL::Simple_cartesian<double>;
using Traits =
    CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Doubles, CGAL::Field_with_sqrt_tag,
                                                                         CGAL::Simple_cartesian<CGAL::Mpzf>,
                                                                         CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;
using Vertex = Graph::Vertex_handle;
using Face = Graph::Face_handle;
using GraphFaceSlot = Slot<struct GraphFaceTag>;

using Roots = CGAL::Simple_cartesian<CORE::Expr>;
using ExactTraits = CGAL::Segment_Delaunay_graph_traits_without_intersections_2<Roots, CGAL::Field_with_sqrt_tag>;

constexpr std::uint32_t kNoRegion = 0xffffffffU;

Vec2 vec_of(const Doubles::Point_2& p) {
  return {p.x(), p.y()};
}

class InnerVoronoi {
 public:
  InnerVoronoi(std::span<const OutlineSide> sides, double tolerance, JobControl& job, bool shows_progress)
      : sides_(sides), job_(job), shows_progress_(shows_progress) {
    double most = 0.0;
    for (const OutlineSide& side : sides)
      for (const Vec2 end : {side.from, side.to}) most = std::max({most, std::abs(end.x), std::abs(end.y)});
    // Powers of distances of large coordinates would leave the doubles. Scaling by a power of two is exact.
    unit_ = std::ldexp(1.0, -std::ilogb(most));
    tolerance_ = unit_ * tolerance;
  }

  OutlineGraph run() {
    insert();
    if (graph_.dimension() < 2) return {};
    number();
    find_ends();
    find_regions();
    collect();
    return std::move(out_);
  }

 private:
  Vec2 scaled(Vec2 p) const { return unit_ * p; }
  void look(std::size_t done, std::size_t total) {
    constexpr std::size_t kOften = 64;
    if (done % kOften == 0) job_.checkpoint(done, shows_progress_ ? total : 0);
  }

  void insert() {
    std::vector<Vec2> points;
    for (const OutlineSide& side : sides_) {
      points.push_back(scaled(side.from));
      points.push_back(scaled(side.to));
    }
    Box2 box;
    for (const Vec2 p : points) box.add(p);
    const HilbertGrid grid(box);
    const auto along_curve = [&](Vec2 a, Vec2 b) {
      return std::tuple(grid.key(a), a.x, a.y) < std::tuple(grid.key(b), b.x, b.y);
    };
    std::ranges::sort(points, along_curve);
    const auto rest = std::ranges::unique(points);
    points.erase(rest.begin(), rest.end());
    const auto index_of = [&](Vec2 p) {
      return static_cast<std::size_t>(std::ranges::lower_bound(points, p, along_curve) - points.begin());
    };
    const std::size_t total = points.size() + 2 * sides_.size();  // a side takes twice as long
    std::size_t done = 0;
    std::vector<Vertex> at(points.size());
    Vertex near;
    for (const std::size_t i : in_rounds<std::size_t>(points.size())) {
      look(done++, total);
      const Doubles::Point_2 p(points[i].x, points[i].y);
      near = at[i] = near == Vertex() ? graph_.insert(p) : graph_.insert(p, near);
    }
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    ends.reserve(sides_.size());
    for (const OutlineSide& side : sides_) ends.emplace_back(index_of(scaled(side.from)), index_of(scaled(side.to)));
    std::ranges::sort(ends);
    for (const std::size_t i : in_rounds<std::size_t>(ends.size())) {
      look(done, total);
      done += 2;
      graph_.insert(at[ends[i].first], at[ends[i].second]);
    }
  }

  /// Numbers features in an order of their own: that of the graph depends on addresses.
  void number() {
    std::vector<std::tuple<bool, double, double, double, double, Vertex>> order;
    for (auto v = graph_.finite_vertices_begin(); v != graph_.finite_vertices_end(); ++v) {
      const auto site = v->site();
      const Vec2 first = vec_of(site.is_point() ? site.point() : site.segment().source());
      const Vec2 second = vec_of(site.is_point() ? site.point() : site.segment().target());
      const auto [from, to] = std::minmax(first, second, lexicographically_less);
      order.emplace_back(site.is_segment(), from.x, from.y, to.x, to.y, v);
    }
    std::ranges::sort(order, [](const auto& a, const auto& b) {
      const auto key = [](const auto& x) {
        return std::tie(std::get<0>(x), std::get<1>(x), std::get<2>(x), std::get<3>(x), std::get<4>(x));
      };
      return key(a) < key(b);
    });
    for (const auto& [is_segment, x, y, to_x, to_y, vertex] : order) {
      OutlineFeature feature{.from = {x, y}, .to = {to_x, to_y}};
      bool separates = false;
      if (is_segment) {
        const OutlineSide& side = sides_[side_between(feature.from, feature.to)];
        feature.smooth = side.smooth;
        if (side.center) feature.center = scaled(*side.center);
        feature.is_arc = side.is_arc;
        separates = side.separates;
      }
      if (is_segment && feature.center)
        chord_.try_emplace(std::pair(feature.smooth.stretch, feature.smooth.number), out_.features.next());
      feature_.emplace(&*vertex, out_.features.next());
      out_.features.push_back(feature);
      separates_.push_back(separates);
    }
    for (auto f = graph_.all_faces_begin(); f != graph_.all_faces_end(); ++f)
      face_.emplace(&*f, GraphFaceSlot(face_.size()));
  }

  /// Both ends scaled, the smaller one first.
  std::size_t side_between(Vec2 a, Vec2 b) const {
    const auto key = [](Vec2 from, Vec2 to) { return std::tuple(from.x, from.y, to.x, to.y); };
    const auto found = std::ranges::lower_bound(
        sides_, key(a, b), {}, [&](const OutlineSide& side) { return key(scaled(side.from), scaled(side.to)); });
    return static_cast<std::size_t>(found - sides_.begin());
  }

  OutlineFeatureSlot feature(Vertex v) const { return feature_.at(&*v); }
  GraphFaceSlot face(Face f) const { return face_.at(&*f); }

  /// The ends of each side, and what lies next to an end along a smooth curve.
  void find_ends() {
    ends_.resize(out_.features.size());
    Table<OutlineFeatureSlot, std::vector<OutlineFeatureSlot>> beside(out_.features.size());
    for (auto v = graph_.finite_vertices_begin(); v != graph_.finite_vertices_end(); ++v) {
      if (!v->is_segment()) continue;
      auto& ends = ends_[feature(v)];
      const OutlineFeature& side = out_.features[feature(v)];
      auto neighbour = graph_.incident_vertices(v);
      const auto first = neighbour;
      do {
        if (graph_.is_infinite(neighbour) || neighbour->is_segment()) continue;
        const OutlineFeatureSlot point = feature(neighbour);
        const Vec2 at = out_.features[point].from;
        if (at != side.from && at != side.to) continue;
        if (ends[0] == point || ends[1] == point) continue;
        ends[ends[0] == kNoSlot ? 0 : 1] = point;
        beside[point].push_back(feature(v));
      } while (++neighbour != first);
    }
    for (const OutlineFeatureSlot i : beside.rows()) {
      if (beside[i].size() != 2) continue;
      std::ranges::sort(beside[i]);
      const OutlineFeature& a = out_.features[beside[i][0]];
      const OutlineFeature& b = out_.features[beside[i][1]];
      if (a.smooth.stretch == SmoothPlace::kNone || a.smooth.stretch != b.smooth.stretch) continue;
      const std::uint32_t low = std::min(a.smooth.number, b.smooth.number);
      const std::uint32_t high = std::max(a.smooth.number, b.smooth.number);
      const std::uint32_t count = a.smooth.count;
      const bool is_at_beginning = count != 0 && high - low + 2 == count;
      if (high - low != 2 && !is_at_beginning) continue;
      OutlineFeature& point = out_.features[i];
      point.smooth = {a.smooth.stretch, (is_at_beginning ? high : low) + 1, count};
      const OutlineFeature& round = a.center ? a : b;
      point.center = round.center;
      point.is_arc = round.is_arc;
    }
  }

  bool is_end_of(OutlineFeatureSlot point, OutlineFeatureSlot side) const {
    return ends_[side][0] == point || ends_[side][1] == point;
  }
  /// A side and one of its ends.
  bool touch(OutlineFeatureSlot a, OutlineFeatureSlot b) const {
    const bool is_a_point = out_.features[a].is_point();
    if (is_a_point == out_.features[b].is_point()) return false;
    return is_a_point ? is_end_of(a, b) : is_end_of(b, a);
  }
  /// The point at which all three features of a finite face meet, or kNoSlot. Its circle is that point.
  OutlineFeatureSlot meeting_point(Face f) const {
    for (int i = 0; i < 3; ++i) {
      const OutlineFeatureSlot p = feature(f->vertex(i));
      if (out_.features[p].is_point() && touch(p, feature(f->vertex((i + 1) % 3))) &&
          touch(p, feature(f->vertex((i + 2) % 3))))
        return p;
    }
    return kNoSlot;
  }

  /// Regions of the plane without the outline are connected sets of Voronoi vertices: no Voronoi edge crosses a side,
  /// apart from those between a side and its own end.
  void find_regions() {
    const GraphFaceSlot outside(face_.size());
    const std::size_t count = face_.size() + 1;
    DisjointSets<GraphFaceSlot> sets(count);
    const auto join = [&sets](GraphFaceSlot a, GraphFaceSlot b) { sets.join(sets.root(a), sets.root(b)); };
    Table<GraphFaceSlot, bool> is_point(count, false);
    for (auto f = graph_.all_faces_begin(); f != graph_.all_faces_end(); ++f) {
      if (graph_.is_infinite(f))
        join(face(f), outside);
      else
        is_point[face(f)] = meeting_point(f) != kNoSlot;
    }
    for (auto e = graph_.all_edges_begin(); e != graph_.all_edges_end(); ++e) {
      const Face f = e->first;
      const Face g = f->neighbor(e->second);
      if (is_point[face(f)] || is_point[face(g)]) continue;
      const Vertex a = f->vertex(Graph::ccw(e->second));
      const Vertex b = f->vertex(Graph::cw(e->second));
      if (graph_.is_infinite(a) || graph_.is_infinite(b) || !touch(feature(a), feature(b))) join(face(f), face(g));
    }
    // A walk over regions, beginning outside.
    Table<GraphFaceSlot, std::vector<std::pair<GraphFaceSlot, bool>>> beyond(count);
    for (auto v = graph_.finite_vertices_begin(); v != graph_.finite_vertices_end(); ++v) {
      if (!v->is_segment()) continue;
      const std::array faces = faces_beside(v, is_point);
      if (faces[0] == kNoSlot || faces[1] == kNoSlot) continue;
      const std::array regions{sets.root(faces[0]), sets.root(faces[1])};
      beyond[regions[0]].emplace_back(regions[1], separates_[feature(v)]);
      beyond[regions[1]].emplace_back(regions[0], separates_[feature(v)]);
    }
    enum class Where : std::uint8_t { unknown, out, in };
    Table<GraphFaceSlot, Where> where(count, Where::unknown);
    std::vector<GraphFaceSlot> open{sets.root(outside)};
    where[open.front()] = Where::out;
    while (!open.empty()) {
      const GraphFaceSlot region = open.back();
      open.pop_back();
      for (const auto& [other, separates] : beyond[region]) {
        if (where[other] != Where::unknown) continue;
        const bool is_inside = (where[region] == Where::in) != separates;
        where[other] = is_inside ? Where::in : Where::out;
        open.push_back(other);
      }
    }
    region_.resize(count);
    for (auto f = graph_.finite_faces_begin(); f != graph_.finite_faces_end(); ++f) {
      const GraphFaceSlot region = sets.root(face(f));
      if (is_point[face(f)] || where[region] != Where::in) continue;
      region_[face(f)] = region;
      if (region == face(f)) ++out_.regions;
    }
  }

  /// Two faces of positive radius, left and right of a side, or kNoSlot. The two ends of the side divide the faces that
  /// surround it.
  std::array<GraphFaceSlot, 2> faces_beside(Vertex v, const Table<GraphFaceSlot, bool>& is_point) const {
    const auto is_behind_end = [&](Face at) {
      const Vertex before = at->vertex(Graph::ccw(at->index(v)));
      return !graph_.is_infinite(before) && is_end_of(feature(before), feature(v));
    };
    auto f = graph_.incident_faces(v);
    while (!is_behind_end(f)) ++f;
    std::array<GraphFaceSlot, 2> out{};
    std::size_t half = 0;
    const auto first = f;
    do {
      if (f != first && is_behind_end(f)) half = 1;
      if (!is_point[face(f)]) out[half] = face(f);
    } while (++f != first);
    return out;
  }

  /// Two sides from one end in nearly the same direction: rounding would place what lies between them anywhere.
  static bool are_a_sliver(const OutlineFeature& a, const OutlineFeature& b) {
    if (a.is_point() || b.is_point()) return false;
    for (const auto& [common, other] : {std::pair{a.from, a.to}, {a.to, a.from}})
      for (const auto& [end, far] : {std::pair{b.from, b.to}, {b.to, b.from}}) {
        const Vec2 u = other - common;
        const Vec2 v = far - end;
        if (common == end && dot(u, v) > 0.0 && std::abs(cross(u, v)) <= 0x1p-40 * dot(u, v)) return true;
      }
    return false;
  }

  using Triple = std::array<OutlineFeatureSlot, 3>;
  /// The features of a face counter-clockwise, the least first. The order decides which circle they define.
  Triple features(Face f) const {
    Triple out{feature(f->vertex(0)), feature(f->vertex(1)), feature(f->vertex(2))};
    std::ranges::rotate(out, std::ranges::min_element(out));
    return out;
  }

  /// False if a feature of the face reaches into the disk, farther than chords do.
  bool is_empty(Face f, const OutlineNode& disk) const {
    constexpr double kChord = 0x1p-9;
    return std::ranges::all_of(features(f), [&](OutlineFeatureSlot i) {
      const OutlineFeature& own = out_.features[i];
      const Vec2 along = own.to - own.from;
      const double size = dot(along, along);
      const double share = size > 0.0 ? std::clamp(dot(disk.center - own.from, along) / size, 0.0, 1.0) : 0.0;
      return distance(own.from + share * along, disk.center) >= (1.0 - kChord) * disk.radius - tolerance_;
    });
  }

  /// A circle touches two features from inside, and one of them is an arc of it. At its centre they are equally far, and
  /// elsewhere in it only along one radius. Chords have edges there, which become the centre or nothing.
  struct InCircle {
    OutlineNode center{};
    bool is_center = false;  ///< the edge becomes the centre; otherwise nothing
  };
  std::optional<InCircle> in_circle(Face f, Face g, const OutlineFeature& a, const OutlineFeature& b) const {
    for (const auto& [arc, other] : {std::pair(&a, &b), {&b, &a}}) {
      if (!arc->is_arc || (other->center && !other->is_arc)) continue;
      const OutlineNode center{*arc->center, distance(arc->from, *arc->center)};
      const double away = std::abs(NearFeature::of(*other, center.center).distance({}) - center.radius);
      constexpr double kLeast = 0x1p-40;
      constexpr double kMost = 0x1p-8;
      if (!(away <= std::clamp(tolerance_, kLeast * center.radius, kMost * center.radius))) continue;
      const double reach = std::max(distance(node_of_chords(f, features(f)).center, center.center),
                                    distance(node_of_chords(g, features(g)).center, center.center));
      constexpr double kAbout = 0.25;
      if (reach <= kAbout * center.radius && is_empty(f, center) && is_empty(g, center))
        return InCircle{center, true};
      const bool is_smooth =
          arc->smooth.stretch != SmoothPlace::kNone && arc->smooth.stretch == other->smooth.stretch;
      if (is_smooth && reach < center.radius) return InCircle{center, false};
    }
    return std::nullopt;
  }

  void collect() {
    struct Kept {
      std::array<OutlineFeatureSlot, 2> features;
      std::array<GraphFaceSlot, 2> nodes;
      GraphFaceSlot region;
    };
    std::vector<Kept> kept;
    std::vector<std::pair<GraphFaceSlot, OutlineNode>> centers;
    DisjointSets<GraphFaceSlot> same(face_.size());
    std::size_t done = 0;
    for (auto e = graph_.finite_edges_begin(); e != graph_.finite_edges_end(); ++e) {
      look(done++, 0);
      const Face f = e->first;
      const Face g = f->neighbor(e->second);
      if (graph_.is_infinite(f) || graph_.is_infinite(g)) continue;
      const GraphFaceSlot region = region_[face(f)] != kNoSlot ? region_[face(f)] : region_[face(g)];
      if (region == kNoSlot) continue;
      const Vertex a = f->vertex(Graph::ccw(e->second));
      const Vertex b = f->vertex(Graph::cw(e->second));
      if (touch(feature(a), feature(b))) continue;
      const Vertex c = f->vertex(e->second);
      const Vertex d = graph_.data_structure().mirror_vertex(f, e->second);
      if (graph_.geom_traits().is_degenerate_edge_2_object()(a->site(), b->site(), c->site(), d->site())) {
        same.join(same.root(face(f)), same.root(face(g)));
        continue;
      }
      const OutlineFeature& first = out_.features[feature(a)];
      const OutlineFeature& second = out_.features[feature(b)];
      if (first.smooth.is_next_to(second.smooth) || are_a_sliver(first, second)) continue;
      if (const auto inside = in_circle(f, g, first, second)) {
        if (!inside->is_center) continue;
        same.join(same.root(face(f)), same.root(face(g)));
        centers.emplace_back(face(f), inside->center);
        continue;
      }
      kept.push_back({{feature(a), feature(b)}, {face(f), face(g)}, region});
    }
    Table<GraphFaceSlot, std::optional<OutlineNode>> arc_center(centers.empty() ? 0 : face_.size());
    for (const auto& [at, center] : centers) arc_center[same.root(at)] = center;
    // The least triple of features stands for a node, and puts nodes and edges in order.
    Table<GraphFaceSlot, Face> least(face_.size());
    Table<GraphFaceSlot, Triple> triple(face_.size());
    for (auto f = graph_.finite_faces_begin(); f != graph_.finite_faces_end(); ++f) {
      const GraphFaceSlot node = same.root(face(f));
      const Triple own = features(f);
      if (least[node] != Face() && triple[node] <= own) continue;
      least[node] = f;
      triple[node] = own;
    }
    Table<GraphFaceSlot, std::uint32_t> edges_at(face_.size(), 0);
    for (Kept& edge : kept) {
      std::ranges::sort(edge.features);
      for (GraphFaceSlot& node : edge.nodes) ++edges_at[node = same.root(node)];
      if (triple[edge.nodes[1]] < triple[edge.nodes[0]]) std::swap(edge.nodes[0], edge.nodes[1]);
    }
    std::ranges::sort(kept, [&](const Kept& a, const Kept& b) {
      return std::tie(a.features, triple[a.nodes[0]], triple[a.nodes[1]]) <
             std::tie(b.features, triple[b.nodes[0]], triple[b.nodes[1]]);
    });
    Table<GraphFaceSlot, OutlineNodeSlot> node(face_.size());
    Table<GraphFaceSlot, std::uint32_t> region(face_.size(), kNoRegion);
    std::uint32_t regions = 0;
    for (const Kept& edge : kept) {
      look(done++, 0);
      for (const GraphFaceSlot end : edge.nodes) {
        if (node[end] != kNoSlot) continue;
        node[end] = out_.nodes.next();
        if (!centers.empty() && arc_center[end])
          out_.nodes.push_back(*arc_center[end]);
        else if (edges_at[end] == 1)
          out_.nodes.push_back(end_at(least[end], triple[end], edge.features));
        else
          out_.nodes.push_back(node_at(least[end], triple[end]));
      }
      if (region[edge.region] == kNoRegion) region[edge.region] = regions++;
      out_.edges.push_back({{node[edge.nodes[0]], node[edge.nodes[1]]}, edge.features, region[edge.region]});
    }
    // The axis of a circle is its centre alone.
    std::ranges::sort(centers, {}, [&](const auto& own) { return triple[same.root(own.first)]; });
    for (const auto& [at, center] : centers) {
      const GraphFaceSlot end = same.root(at);
      const GraphFaceSlot inside = region_[at];
      if (node[end] != kNoSlot || inside == kNoSlot || region[inside] != kNoRegion) continue;
      node[end] = out_.nodes.next();
      out_.nodes.push_back(center);
      region[inside] = regions++;
    }
    for (OutlineFeature& feature : out_.features) {
      feature.from = (1.0 / unit_) * feature.from;
      feature.to = (1.0 / unit_) * feature.to;
      if (feature.center) feature.center = (1.0 / unit_) * *feature.center;
    }
    for (OutlineNode& place : out_.nodes) {
      place.center = (1.0 / unit_) * place.center;
      place.radius /= unit_;
    }
  }

  /// `around` are the features of the face. Positions count from one of them: far from the origin of the plane, as on a
  /// map, errors of rounding in the construction exceed the width of a thin shape.
  OutlineNode node_at(Face f, const Triple& around) const {
    OutlineNode node = node_of_chords(f, around);
    const Vec2 origin = out_.features[around[0]].from;
    if (const auto moved = on_curves({node.center - origin, node.radius}, origin, around))
      node = {origin + moved->center, moved->radius};
    return node;
  }
  OutlineNode node_of_chords(Face f, const Triple& around) const {
    if (const OutlineFeatureSlot p = meeting_point(f); p != kNoSlot) return {out_.features[p].from, 0.0};
    const Vec2 origin = out_.features[around[0]].from;
    const OutlineNode node = node_from(origin, around);
    return {origin + node.center, node.radius};
  }

  /// A node at which a single edge ends, of these two features. In the middle of a smooth curve that is the centre of
  /// curvature where the curve turns most; it is interpolated between the circles of three chords.
  OutlineNode end_at(Face f, const Triple& around, const std::array<OutlineFeatureSlot, 2>& beside) const {
    const OutlineNode usual = node_at(f, around);
    const auto is_beside = [&](OutlineFeatureSlot i) { return i == beside[0] || i == beside[1]; };
    const SmoothPlace& place = out_.features[*std::ranges::find_if_not(around, is_beside)].smooth;
    const auto is_next = [&](OutlineFeatureSlot i) { return out_.features[i].smooth.is_next_to(place); };
    if (std::ranges::count_if(around, is_beside) != 2 || !std::ranges::all_of(beside, is_next)) return usual;
    // The circle of the chord so many steps farther along the curve, if it holds the node.
    const auto circle = [&](std::int64_t steps) -> std::optional<OutlineNode> {
      const std::int64_t number = place.number + steps;
      const std::int64_t count = place.count;
      const auto chord =
          chord_.find({place.stretch, static_cast<std::uint32_t>(count == 0 ? number : (number + count) % count)});
      if (chord == chord_.end() || !out_.features[chord->second].center) return std::nullopt;
      const OutlineFeature& feature = out_.features[chord->second];
      const double radius = distance(feature.from, *feature.center);
      if (distance(*feature.center, usual.center) > radius) return std::nullopt;
      return OutlineNode{*feature.center, radius};
    };
    constexpr std::int64_t kReach = 4;  // see SmoothPlace::is_next_to
    std::optional<OutlineNode> most;
    std::int64_t at = 0;
    for (std::int64_t steps = -kReach + place.number % 2; steps <= kReach; steps += 2) {
      const std::optional<OutlineNode> one = circle(steps);
      if (!one || (most && most->radius <= one->radius)) continue;
      most = one;
      at = steps;
    }
    if (!most) return usual;
    OutlineNode out = *most;
    const std::optional<OutlineNode> before = circle(at - 2);
    const std::optional<OutlineNode> after = circle(at + 2);
    const double low = before ? most->radius / before->radius - 1.0 : 0.0;
    const double high = after ? most->radius / after->radius - 1.0 : 0.0;
    if (low > 0.0 || high > 0.0) return usual;  // the curve turns more farther away
    constexpr double kSmooth = -0.25;           // otherwise the curvature jumps
    if (before && after && low > kSmooth && high > kSmooth && low + high < 0.0) {
      const double share = 0.5 * (low - high) / (low + high);
      const auto between = [share](auto a, auto b, auto c) {
        return 0.5 * share * (share - 1.0) * a + (1.0 - share * share) * b + 0.5 * share * (share + 1.0) * c;
      };
      out = {between(before->center, most->center, after->center),
             between(before->radius, most->radius, after->radius)};
    }
    // The new disk must lie in that of the chords, up to the distance between curve and chords.
    constexpr double kAway = 0x1p-10;
    return distance(out.center, usual.center) + out.radius <= (1.0 + kAway) * usual.radius ? out : usual;
  }

  /// The node above a point at which a side ends, if two of the features are these.
  std::optional<OutlineNode> above_end(const Triple& around, const NearFeatures& near, Vec2 about) const {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 1; k < 3; ++k) {
        const std::size_t j = (i + k) % 3;
        if (!out_.features[around[i]].is_point() || !touch(around[i], around[j])) continue;
        if (const auto foot = equally_far_above_end(near, i, j, about)) return foot;
      }
    return std::nullopt;
  }

  NearFeatures round(const Triple& around, Vec2 origin) const {
    const auto near = [&](OutlineFeatureSlot i) { return NearFeature::of(out_.features[i], origin); };
    return {near(around[0]), near(around[1]), near(around[2])};
  }
  NearFeatures straight(const Triple& around, Vec2 origin) const {
    const auto near = [&](OutlineFeatureSlot i) {
      OutlineFeature feature = out_.features[i];
      feature.center.reset();
      return NearFeature::of(feature, origin);
    };
    return {near(around[0]), near(around[1]), near(around[2])};
  }

  /// False if the nearest point on the circle of a round side is far from the chord, where the curve need not be.
  bool has_foot_of(OutlineFeatureSlot slot, Vec2 p) const {
    const OutlineFeature& feature = out_.features[slot];
    if (!feature.center) return true;
    const double radius = distance(feature.from, *feature.center);
    const Vec2 way = p - *feature.center;
    const Vec2 foot = *feature.center + (radius / length(way)) * way;
    constexpr double kTwoChords = 0.125;  // in radians
    return distance(foot, feature.from) <= 2.0 * std::max(distance(feature.from, feature.to), kTwoChords * radius);
  }

  /// The node of the curves that chords stand for, beside that of the chords. Nothing if all sides are straight, at ends
  /// in the middle of a smooth curve, and where Newton's method finds nothing near.
  std::optional<OutlineNode> on_curves(const OutlineNode& node, Vec2 origin, const Triple& around) const {
    const auto is_round = [this](OutlineFeatureSlot i) { return out_.features[i].center.has_value(); };
    if (std::ranges::none_of(around, is_round)) return std::nullopt;
    const NearFeatures near = round(around, origin);
    std::optional<OutlineNode> found;
    std::size_t pairs = 0;
    std::size_t first = 0;  // of the last pair of neighbours along a curve
    for (std::size_t i = 0; i < 3; ++i) {
      const OutlineFeature& other = out_.features[around[(i + 1) % 3]];
      if (!out_.features[around[i]].smooth.is_next_to(other.smooth)) continue;
      ++pairs;
      first = i;
    }
    if (pairs == 0) found = above_end(around, near, node.center);
    if (pairs == 0 && !found) found = equally_far(near, node.center);
    if (pairs == 1) {
      const std::size_t second = (first + 1) % 3;
      found = equally_far_from_two(near, (first + 2) % 3, is_round(around[first]) ? first : second, node.center);
    }
    if (!found || !(distance(found->center, node.center) <= 0.5 * node.radius)) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i)
      if (!has_foot_of(around[i], found->center + origin)) return std::nullopt;
    return found;
  }

  OutlineNode node_from(Vec2 origin, const Triple& around) const {
    const NearFeatures near = straight(around, origin);
    const auto site = [&](OutlineFeatureSlot slot) {
      const OutlineFeature& feature = out_.features[slot];
      return site_between<Traits, Doubles>(feature.from - origin, feature.to - origin);
    };
    const Vec2 at = vec_of(Traits::Construct_svd_vertex_2()(site(around[0]), site(around[1]), site(around[2])));
    if (const auto foot = above_end(around, near, at)) return *foot;
    if (const auto polished = equally_far(near, at)) return *polished;
    return exact_node(origin, around, near);
  }

  /// A segment, or a point if both ends are the same.
  template <class SiteTraits, class Kernel>
  static typename SiteTraits::Site_2 site_between(Vec2 from, Vec2 to) {
    using Number = typename Kernel::FT;
    const auto point = [](Vec2 p) { return typename Kernel::Point_2(Number(p.x), Number(p.y)); };
    return from == to ? SiteTraits::Site_2::construct_site_2(point(from))
                      : SiteTraits::Site_2::construct_site_2(point(from), point(to));
  }

  /// For positions that doubles do not find.
  OutlineNode exact_node(Vec2 origin, const Triple& around, const NearFeatures& near) const {
    const auto site = [&](OutlineFeatureSlot slot) {
      const OutlineFeature& feature = out_.features[slot];
      return site_between<ExactTraits, Roots>(feature.from, feature.to);
    };
    const auto at = ExactTraits::Construct_svd_vertex_2()(site(around[0]), site(around[1]), site(around[2]));
    const Vec2 rounded{CGAL::to_double(at.x() - CORE::Expr(origin.x)),
                       CGAL::to_double(at.y() - CORE::Expr(origin.y))};
    return {rounded, (near[0].distance(rounded) + near[1].distance(rounded) + near[2].distance(rounded)) / 3.0};
  }

  std::span<const OutlineSide> sides_;
  JobControl& job_;
  bool shows_progress_;
  double unit_ = 1.0;
  double tolerance_ = 0.0;  // within which arcs touch, scaled
  Graph graph_;
  std::unordered_map<const void*, OutlineFeatureSlot> feature_;
  std::unordered_map<const void*, GraphFaceSlot> face_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, OutlineFeatureSlot> chord_;  // by stretch and number along it
  Table<OutlineFeatureSlot, std::array<OutlineFeatureSlot, 2>> ends_;            // of sides
  Table<OutlineFeatureSlot, bool> separates_;                                    // sides
  Table<GraphFaceSlot, GraphFaceSlot> region_;  // kNoSlot outside, and where the features of a face meet
  OutlineGraph out_;
};

}  // namespace

OutlineGraph inner_voronoi(std::span<const OutlineSide> sides, double tolerance, JobControl& job,
                           bool shows_progress) {
  if (sides.empty()) return {};
  return InnerVoronoi(sides, tolerance, job, shows_progress).run();
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/explain.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/inputs/user_balls.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {
namespace {

using Role = ProvenanceRole;

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}
std::string place(Vec2 p) {
  return "(" + number(p.x) + ", " + number(p.y) + ")";
}
std::string count_of(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Shapes of one line.
class Shapes {
 public:
  void point(Vec2 p) { add(PrimitiveKind::point, {p.x, p.y}); }
  void circle(const Disk& disk) { add(PrimitiveKind::circle, {disk.center.x, disk.center.y, disk.radius}); }
  void segment(Vec2 a, Vec2 b) { add(PrimitiveKind::segment, {a.x, a.y, b.x, b.y}); }
  void ray(Vec2 from, Vec2 towards) { add(PrimitiveKind::ray, {from.x, from.y, towards.x, towards.y}); }
  void line(Vec2 through, Vec2 along) { add(PrimitiveKind::line, {through.x, through.y, along.x, along.y}); }
  void arc(const Disk& disk, Vec2 from, Vec2 to) {
    add(PrimitiveKind::arc, {disk.center.x, disk.center.y, disk.radius, from.x, from.y, to.x, to.y});
  }
  void triangle(Vec2 a, Vec2 b, Vec2 c) { add(PrimitiveKind::triangle, {a.x, a.y, b.x, b.y, c.x, c.y}); }
  std::size_t size() const { return shapes_.size(); }
  std::vector<ProvenanceShape> take() { return std::move(shapes_); }

 private:
  void add(PrimitiveKind kind, std::array<double, 7> values) {
    if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) shapes_.push_back({kind, values});
  }
  std::vector<ProvenanceShape> shapes_;
};

class Explanation {
 public:
  Explanation(const StructureSet& set, const std::function<bool(const Structure&)>& is_current)
      : set_(set), is_current_(is_current) {}

  std::vector<ProvenanceLine> take() { return std::move(lines_); }
  void about(const Element& element);

 private:
  template <class T>
  const T* current() const {
    const T& structure = set_.get<T>();
    return is_current_(structure) ? &structure : nullptr;
  }
  void say(Role role, std::string text, Shapes& shapes) { lines_.push_back({role, std::move(text), shapes.take()}); }
  /// Only if there is something to show.
  void say_any(Role role, const std::string& one, const std::string& many, Shapes& shapes) {
    if (const std::size_t count = shapes.size(); count != 0) say(role, count_of(count, one, many), shapes);
  }

  void about_site(Slot site);
  void about_voronoi_vertex(Slot face);
  void about_edge(Slot edge);
  void about_own_ball(Slot row);
  void about_scaled_ball(const BallFamily& family, Slot row);
  void about_ball(const BallUnion& balls, Slot row);
  void about_place_in_union(const BallUnion& balls, Slot row);
  void about_dual_edge(const BallUnion& balls, Slot row);
  void about_dual_face(const BallUnion& balls, Slot row);
  void about_v_point(const BallUnion& balls, Slot row);
  void about_axis_piece(const BallUnion& balls, Slot row);
  void about_arc(const BallUnion& balls, Slot row);
  void about_v_face(const VDiagram& diagram, Slot row);
  void about_v_edge(const VDiagram& diagram, Slot row);
  void about_power_edge(const PowerDiagram& diagram, Slot row);
  void power_cell(const PowerDiagram& diagram, Slot ball);
  void dual(Shapes& shapes, Slot edge) const;
  void face_triangle(Shapes& shapes, Slot face) const {
    const auto& v = delaunay().face(face).v;
    shapes.triangle(delaunay().site_position(v[0]), delaunay().site_position(v[1]), delaunay().site_position(v[2]));
  }
  Disk disk_of(Slot face) const { return {delaunay().circumcenter(face), delaunay().circumradius(face)}; }
  const Delaunay& delaunay() const { return set_.get<Delaunay>(); }

  const StructureSet& set_;
  const std::function<bool(const Structure&)>& is_current_;
  std::vector<ProvenanceLine> lines_;
};

// The Voronoi edge; one that leads to infinity as a ray.
void Explanation::dual(Shapes& shapes, Slot edge) const {
  const EdgeRow& row = delaunay().edge(edge);
  const Vec2 a = delaunay().site_position(row.v[0]);
  const Vec2 b = delaunay().site_position(row.v[1]);
  if (row.f[0] == kNoSlot) return shapes.line(0.5 * (a + b), perpendicular(b - a));
  const bool left = delaunay().is_finite_face(row.f[0]);
  const bool right = delaunay().is_finite_face(row.f[1]);
  if (left && right) return shapes.segment(delaunay().circumcenter(row.f[0]), delaunay().circumcenter(row.f[1]));
  if (left) return shapes.ray(delaunay().circumcenter(row.f[0]), -perpendicular(b - a));
  shapes.ray(delaunay().circumcenter(row.f[1]), perpendicular(b - a));
}

void Explanation::about_site(Slot site) {
  if (!current<Delaunay>() || !delaunay().is_site(site)) return;
  Shapes shapes;
  shapes.point(delaunay().site_position(site));
  std::size_t copies = 0;
  for (Slot s = delaunay().site_sample(site); s != kNoSlot; s = delaunay().next_duplicate(s)) ++copies;
  say(Role::itself,
      "Sample at " + place(delaunay().site_position(site)) +
          (copies > 1 ? ", " + std::to_string(copies) + " times" : ""),
      shapes);
  Shapes cell, curve, balls, poles;
  const auto* crust = current<OneStepCrust>();
  const auto* inner = current<InnerBalls>();
  std::vector<Slot> seen;
  delaunay().for_each_edge_at(site, [&](Slot edge, Slot other, Slot left) {
    dual(cell, edge);
    if (crust != nullptr && crust->is_crust(edge))
      curve.segment(delaunay().site_position(site), delaunay().site_position(other));
    if (inner == nullptr || left == kNoSlot || !delaunay().is_finite_face(left) || !inner->is_ball(left)) return;
    if (std::ranges::find(seen, inner->ball(left)) != seen.end()) return;
    seen.push_back(inner->ball(left));
    balls.circle(disk_of(inner->ball(left)));
  });
  say_any(Role::product, "side of its Voronoi cell", "sides of its Voronoi cell", cell);
  say_any(Role::product, "curve edge", "curve edges", curve);
  say_any(Role::product, "inner Voronoi ball touches it", "inner Voronoi balls touch it", balls);
  if (const auto* known = current<Poles>(); known != nullptr && delaunay().dimension() == 2) {
    for (const Slot pole : {known->plus(site), known->minus(site)})
      if (pole != kNoSlot && pole != kInfinitePole) poles.point(delaunay().circumcenter(pole));
    const bool is_hull = known->plus(site) == kInfinitePole;
    say_any(Role::product, is_hull ? "pole, and one at infinity" : "pole", "poles", poles);
  }
  if (const auto* a = current<AUnion>(); a != nullptr && a->rung() == UnionRung::shortcut) {
    shapes.point(delaunay().site_position(site));
    const std::uint32_t touched = a->tables().v_points[site].multiplicity;
    if (touched >= 2) say(Role::product, "it is a v-point of union A", shapes);
  }
}

void Explanation::about_voronoi_vertex(Slot face) {
  if (!current<Delaunay>() || !delaunay().is_finite_face(face)) return;
  const auto* vertices = current<VoronoiVertices>();
  const Slot vertex = vertices != nullptr ? vertices->vertex(face) : face;
  const Disk disk = disk_of(vertex);
  const auto* labels = current<Labels>();
  const bool is_inside = labels != nullptr && labels->is_inside(face);
  Shapes itself, samples, triangles, edges, axis;
  itself.point(disk.center);
  itself.circle(disk);
  say(Role::itself,
      std::string(labels == nullptr ? "Voronoi vertex" : (is_inside ? "Inner Voronoi ball" : "Outer Voronoi ball")) +
          " at " + place(disk.center) + ", radius " + number(disk.radius),
      itself);
  std::vector<Slot> sites;
  std::vector<Slot> faces{face};
  if (vertices != nullptr) {
    vertices->append_sites(face, sites);
    if (const auto* group = vertices->group(face)) faces = *group;
  } else {
    sites.assign(std::begin(delaunay().face(face).v), std::end(delaunay().face(face).v));
  }
  for (const Slot site : sites) samples.point(delaunay().site_position(site));
  say(Role::origin, "touches " + count_of(sites.size(), "sample", "samples"), samples);
  const auto* crust = current<OneStepCrust>();
  const auto* medial = current<MedialAxis>();
  for (const Slot f : faces) {
    face_triangle(triangles, f);
    for (const Slot edge : delaunay().face(f).e) {
      if (edge == kNoSlot || (crust != nullptr && crust->is_cocircular(edge))) continue;
      dual(medial != nullptr && medial->is_axis_edge(edge) ? axis : edges, edge);
    }
  }
  say_any(Role::origin, "Delaunay triangle", "Delaunay triangles on one circle", triangles);
  say_any(Role::product, "medial axis edge ends here", "medial axis edges end here", axis);
  say_any(Role::product, "other Voronoi edge", "other Voronoi edges", edges);
  if (const auto* poles = current<Poles>(); poles != nullptr && poles->is_pole(vertex)) {
    Shapes of;
    for (const Slot site : sites)
      if (poles->plus(site) == vertex || poles->minus(site) == vertex) of.point(delaunay().site_position(site));
    say_any(Role::product, "sample has it as a pole", "samples have it as a pole", of);
  }
  if (const auto* a = current<AUnion>(); a != nullptr && is_inside) about_place_in_union(*a, vertex);
  if (const auto* diagram = current<APowerDiagram>(); diagram != nullptr && is_inside) power_cell(*diagram, vertex);
}

void Explanation::about_edge(Slot edge) {
  if (!current<Delaunay>() || !delaunay().edge(edge).is_alive()) return;
  const EdgeRow& row = delaunay().edge(edge);
  const Vec2 a = delaunay().site_position(row.v[0]);
  const Vec2 b = delaunay().site_position(row.v[1]);
  const auto* crust = current<OneStepCrust>();
  const auto* medial = current<MedialAxis>();
  const bool is_axis = medial != nullptr && medial->is_axis_edge(edge);
  std::string what = "Delaunay edge and its Voronoi edge";
  if (crust != nullptr)
    what = crust->is_crust(edge) ? "Curve edge" : (is_axis ? "Medial axis edge" : "Skeleton edge");
  Shapes itself, samples, triangles, balls;
  itself.segment(a, b);
  dual(itself, edge);
  say(Role::itself, what + ", samples " + number(distance(a, b)) + " apart", itself);
  samples.point(a);
  samples.point(b);
  say(Role::origin, "2 samples, both at equal distance all along the Voronoi edge", samples);
  for (const Slot face : row.f) {
    if (face == kNoSlot || !delaunay().is_finite_face(face)) continue;
    face_triangle(triangles, face);
    balls.circle(disk_of(face));
  }
  say_any(Role::origin, "Delaunay triangle at it", "Delaunay triangles at it", triangles);
  say_any(Role::product, "Voronoi ball at its one end", "Voronoi balls at its ends", balls);
}

// What a union makes of one of its balls.
void Explanation::about_place_in_union(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.balls.size()) return;
  Shapes edges, triangles, points, arcs;
  std::vector<Slot> own_edges;
  for (Slot e = 0; e < t.dual_edges.size(); ++e) {
    const DualEdge& edge = t.dual_edges[e];
    if (!edge.is_alive() || (edge.ball[0] != row && edge.ball[1] != row)) continue;
    own_edges.push_back(e);
    edges.segment(balls.family().disk(edge.ball[0]).center, balls.family().disk(edge.ball[1]).center);
  }
  for (const DualFace& face : t.dual_faces)
    if (face.is_alive() && std::ranges::find(face.ball, row) != std::end(face.ball))
      triangles.triangle(balls.family().disk(face.ball[0]).center, balls.family().disk(face.ball[1]).center,
                         balls.family().disk(face.ball[2]).center);
  std::size_t free_arcs = 0;
  std::vector<Vec2> ends;
  for (const BoundaryArc& arc : t.arcs) {
    if (!arc.is_alive() || arc.ball != row) continue;
    ++free_arcs;
    if (arc.is_whole != 0) continue;
    for (const Vec2 end : {arc.from, arc.to})
      if (std::ranges::find(ends, end) == ends.end()) ends.push_back(end);
  }
  for (const Vec2 end : ends) points.point(end);
  say_any(Role::product, "dual edge at it", "dual edges at it", edges);
  say_any(Role::product, "dual triangle at it", "dual triangles at it", triangles);
  say_any(Role::product, "end of its arcs on the boundary of the union",
          "ends of its " + count_of(free_arcs, "arc", "arcs") + " on the boundary of the union", points);
}

void Explanation::about_own_ball(Slot row) {
  const auto* own = current<UserBalls>();
  if (own == nullptr || !own->is_alive(row)) return;
  Shapes itself;
  itself.circle(own->disk(row));
  itself.point(own->disk(row).center);
  say(Role::itself, "Ball at " + place(own->disk(row).center) + ", radius " + number(own->disk(row).radius), itself);
  if (const auto* b = current<BUnion>()) {
    about_scaled_ball(b->family(), row);
    about_place_in_union(*b, row);
  }
  if (const auto* diagram = current<BPowerDiagram>()) power_cell(*diagram, row);
}

void Explanation::about_scaled_ball(const BallFamily& family, Slot row) {
  if (family.scale() == 1.0) return;
  Shapes circle;
  circle.circle(family.disk(row));
  say(Role::product,
      "Scaled by " + number(family.scale()) + " for its union: radius " + number(family.disk(row).radius), circle);
}

void Explanation::about_ball(const BallUnion& balls, Slot row) {
  if (!balls.family().is_ball(row)) return;
  if (!balls.family().is_from_samples()) return about_own_ball(row);
  about_voronoi_vertex(row);
  about_scaled_ball(balls.family(), row);
  if (&balls != static_cast<const BallUnion*>(&set_.get<AUnion>())) about_place_in_union(balls, row);
}

void Explanation::power_cell(const PowerDiagram& diagram, Slot ball) {
  Shapes cell;
  for (const PowerEdge& edge : diagram.edges()) {
    if (edge.ball[0] != ball && edge.ball[1] != ball) continue;
    switch (edge.kind) {
      case PowerEdge::Kind::segment: cell.segment(edge.from, edge.to); break;
      case PowerEdge::Kind::ray: cell.ray(edge.from, edge.to); break;
      case PowerEdge::Kind::line: cell.line(edge.from, edge.to); break;
    }
  }
  say_any(Role::product, "side of its power cell", "sides of its power cell", cell);
}

void Explanation::about_dual_edge(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.dual_edges.size() || !t.dual_edges[row].is_alive()) return;
  const DualEdge& edge = t.dual_edges[row];
  const Disk a = balls.family().disk(edge.ball[0]);
  const Disk b = balls.family().disk(edge.ball[1]);
  Shapes itself, circles, points;
  itself.segment(a.center, b.center);
  constexpr const char* kClass[] = {"Singular dual edge: no dual triangle at it",
                                    "Regular dual edge: one dual triangle at it",
                                    "Interior dual edge: between two dual triangles"};
  say(Role::itself, kClass[static_cast<std::size_t>(edge.kind)], itself);
  circles.circle(a);
  circles.circle(b);
  say(Role::origin,
      std::string("2 balls that meet within their power cells") +
          (balls.family().touch_samples() && edge.shares_sample != 0 ? ", and share a sample" : ""),
      circles);
  for (const VOrigin& origin : t.v_origins)
    if (origin.is_alive() && origin.edge == row) points.point(t.v_points[origin.v].position);
  say_any(Role::product, "v-point made by it", "v-points made by it", points);
}

void Explanation::about_dual_face(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.dual_faces.size() || !t.dual_faces[row].is_alive()) return;
  const DualFace& face = t.dual_faces[row];
  Shapes itself, circles, common;
  itself.triangle(balls.family().disk(face.ball[0]).center, balls.family().disk(face.ball[1]).center,
                  balls.family().disk(face.ball[2]).center);
  say(Role::itself,
      face.sign < 0
          ? "Dual triangle: its three balls have a common interior point"
          : "Dual triangle: its three balls meet in one point only, their orthogonal circle has radius zero",
      itself);
  std::vector<TouchedSample> shared;
  for (std::size_t i = 0; i < 3; ++i) {
    circles.circle(balls.family().disk(face.ball[i]));
    std::vector<TouchedSample> touched;
    if (balls.family().touch_samples()) balls.family().touched_samples(face.ball[i], touched);
    if (i == 0) {
      shared = touched;
    } else {
      std::erase_if(shared, [&touched](const TouchedSample& sample) {
        return std::ranges::find(touched, sample.site, &TouchedSample::site) == touched.end();
      });
    }
  }
  say(Role::origin, "3 balls", circles);
  for (const TouchedSample& sample : shared) common.point(sample.position);
  say_any(Role::origin, "sample that all three touch", "samples that all three touch", common);
}

void Explanation::about_v_point(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.v_points.size() || !t.v_points[row].is_alive()) return;
  const VPoint& v = t.v_points[row];
  Shapes itself, edges, circles, pieces;
  itself.point(v.position);
  const bool is_foreign = balls.family().touch_samples() && v.site == kNoSlot;
  say(Role::itself,
      "V-point at " + place(v.position) + (v.site != kNoSlot ? ", a sample" : (is_foreign ? ", no sample" : "")),
      itself);
  std::vector<Slot> touching;
  const auto add_ball = [&](Slot ball) {
    if (std::ranges::find(touching, ball) != touching.end()) return;
    touching.push_back(ball);
    circles.circle(balls.family().disk(ball));
  };
  for (const VOrigin& origin : t.v_origins) {
    if (!origin.is_alive() || origin.v != row) continue;
    const DualEdge& edge = t.dual_edges[origin.edge];
    edges.segment(balls.family().disk(edge.ball[0]).center, balls.family().disk(edge.ball[1]).center);
    for (const Slot ball : edge.ball) add_ball(ball);
  }
  for (const AxisPiece& piece : t.axis) {
    if (!piece.is_alive() || (piece.v[0] != row && piece.v[1] != row)) continue;
    pieces.segment(piece.a, piece.b);
    for (const Slot node : piece.node)
      if (node < t.balls.size()) add_ball(node);
  }
  say_any(Role::origin, "ball whose circle passes through it", "balls whose circles cross here", circles);
  say_any(Role::origin, "dual edge that made it", "dual edges that made it", edges);
  say_any(Role::product, "piece of the axis has it as a nearest boundary point",
          "pieces of the axis have it as a nearest boundary point", pieces);
}

void Explanation::about_axis_piece(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.axis.size() || !t.axis[row].is_alive()) return;
  const AxisPiece& piece = t.axis[row];
  Shapes itself, points, circles;
  itself.segment(piece.a, piece.b);
  say(Role::itself,
      std::string(piece.is_singular != 0 ? "Piece of the axis along a singular dual edge"
                                         : "Piece of the axis on the Voronoi diagram of the v-points") +
          ", radius " + number(piece.radius_a) + " to " + number(piece.radius_b),
      itself);
  for (const Slot v : piece.v)
    if (v != kNoSlot && v < t.v_points.size() && t.v_points[v].is_alive()) points.point(t.v_points[v].position);
  say_any(Role::origin, "v-point nearest to all of it", "v-points nearest to all of it", points);
  for (std::size_t i = 0; i < 2; ++i)
    circles.circle(i == 0 ? Disk{piece.a, piece.radius_a} : Disk{piece.b, piece.radius_b});
  say(Role::origin, "the maximal balls at its two ends", circles);
}

void Explanation::about_arc(const BallUnion& balls, Slot row) {
  const UnionTables& t = balls.tables();
  if (row >= t.arcs.size() || !t.arcs[row].is_alive()) return;
  Shapes itself, circle;
  if (const auto drawn = drawn_arc(t.arcs[row], balls.family().disk(t.arcs[row].ball)))
    itself.arc({drawn->center, drawn->radius}, drawn->from, drawn->to);
  say(Role::itself,
      t.arcs[row].is_whole != 0 ? "A whole circle on the boundary of the union"
                                : "Arc on the boundary of the union, between two v-points",
      itself);
  circle.circle(balls.family().disk(t.arcs[row].ball));
  say(Role::origin, "its ball", circle);
}

void Explanation::about_v_face(const VDiagram& diagram, Slot row) {
  const UnionTables& t = diagram.tables();
  if (row >= t.v_faces.size()) return;
  const VFace& face = t.v_faces[row];
  Shapes itself, points;
  itself.point(face.center);
  itself.circle({face.center, face.radius});
  say(Role::itself,
      std::string("Voronoi vertex of the v-points ") + (face.is_inside != 0 ? "inside" : "outside") +
          " the dual complex" + (face.ball != kNoSlot ? ", the centre of a ball" : ""),
      itself);
  for (const Slot v : face.v) points.point(t.v_points[v].position);
  say(Role::origin, "3 v-points on its circle", points);
}

void Explanation::about_v_edge(const VDiagram& diagram, Slot row) {
  const UnionTables& t = diagram.tables();
  if (row >= t.v_edges.size()) return;
  const VEdge& edge = t.v_edges[row];
  Shapes itself, points;
  itself.segment(t.v_points[edge.v[0]].position, t.v_points[edge.v[1]].position);
  constexpr const char* kKind[] = {"Voronoi edge of two v-points",
                                   "Voronoi edge of two v-points, through a ball's centre",
                                   "Voronoi edge of two v-points, along a singular dual edge"};
  say(Role::itself, kKind[static_cast<std::size_t>(edge.kind)], itself);
  for (const Slot v : edge.v) points.point(t.v_points[v].position);
  say(Role::origin, "2 v-points", points);
}

void Explanation::about_power_edge(const PowerDiagram& diagram, Slot row) {
  if (row >= diagram.edges().size()) return;
  const PowerEdge& edge = diagram.edges()[row];
  Shapes itself, circles;
  switch (edge.kind) {
    case PowerEdge::Kind::segment: itself.segment(edge.from, edge.to); break;
    case PowerEdge::Kind::ray: itself.ray(edge.from, edge.to); break;
    case PowerEdge::Kind::line: itself.line(edge.from, edge.to); break;
  }
  const Disk a = diagram.family().disk(edge.ball[0]);
  const Disk b = diagram.family().disk(edge.ball[1]);
  itself.segment(a.center, b.center);
  say(Role::itself, "Edge of the power diagram, and of the triangulation of the balls", itself);
  circles.circle(a);
  circles.circle(b);
  say(Role::origin, "2 balls of equal power along it", circles);
}

void Explanation::about(const Element& element) {
  const Structure* owner = element.type.owner;
  if (owner != nullptr && !is_current_(*owner)) return;
  const auto in_union = [&](void (Explanation::*part)(const BallUnion&, Slot)) {
    (this->*part)(dynamic_cast<const BallUnion&>(*owner), element.row);
  };
  switch (element.type.kind) {
    case ElementKind::other: break;
    case ElementKind::sample:
      if (current<Delaunay>()) {
        const Slot site = delaunay().site_of_sample(element.row);
        if (site != kNoSlot) about_site(site);
      }
      break;
    case ElementKind::site: about_site(element.row); break;
    case ElementKind::voronoi_vertex: about_voronoi_vertex(element.row); break;
    case ElementKind::delaunay_edge: about_edge(element.row); break;
    case ElementKind::own_ball: about_own_ball(element.row); break;
    case ElementKind::ball: in_union(&Explanation::about_ball); break;
    case ElementKind::dual_edge: in_union(&Explanation::about_dual_edge); break;
    case ElementKind::dual_face: in_union(&Explanation::about_dual_face); break;
    case ElementKind::v_point:
      // The diagram of the v-points shows them too.
      if (dynamic_cast<const BallUnion*>(owner) != nullptr) in_union(&Explanation::about_v_point);
      break;
    case ElementKind::v_origin: {
      const auto& balls = dynamic_cast<const BallUnion&>(*owner);
      if (element.row < balls.tables().v_origins.size() && balls.tables().v_origins[element.row].is_alive())
        about_v_point(balls, balls.tables().v_origins[element.row].v);
      break;
    }
    case ElementKind::axis_piece: in_union(&Explanation::about_axis_piece); break;
    case ElementKind::boundary_arc: in_union(&Explanation::about_arc); break;
    case ElementKind::v_face: about_v_face(dynamic_cast<const VDiagram&>(*owner), element.row); break;
    case ElementKind::v_edge: about_v_edge(dynamic_cast<const VDiagram&>(*owner), element.row); break;
    case ElementKind::power_edge: about_power_edge(dynamic_cast<const PowerDiagram&>(*owner), element.row); break;
  }
}

}  // namespace

std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element) {
  Explanation explanation(set, is_current);
  explanation.about(element);
  return explanation.take();
}

}  // namespace mes

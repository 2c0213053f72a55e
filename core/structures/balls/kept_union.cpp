// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/kept_union.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/base/sum.h"
#include "core/graph/explain.h"
#include "core/kernel/corner_angle.h"

namespace mes {
namespace {

class KeptBalls final : public BallFamily {
 public:
  explicit KeptBalls(const AxisFilter& filter) : filter_(filter), delaunay_(filter.delaunay()) {}

  std::size_t rows() const override { return 2 * std::max(delaunay_.face_rows(), 2 * delaunay_.edge_rows()); }
  bool is_ball(FamilySlot row) const override {
    if (row.index() % 2 == 0) {
      const FaceSlot face(row.index() / 2);
      return face.index() < delaunay_.face_rows() && delaunay_.is_finite_face(face) && filter_.is_kept(face);
    }
    const EdgeSlot edge(row.index() / 4);
    return edge.index() < delaunay_.edge_rows() && filter_.is_kept(edge) && filter_.is_cut(edge, end_of(row));
  }
  // A ball about a point of an edge touches both samples; its radius is the distance to the one that comes first.
  Disk plain_disk(FamilySlot row) const override {
    if (row.index() % 2 == 0) {
      const FaceSlot face(row.index() / 2);
      return {delaunay_.circumcenter(face), delaunay_.circumradius(face)};
    }
    const EdgeSlot edge(row.index() / 4);
    const Vec2 p = delaunay_.site_position(delaunay_.edge(edge).v[0]);
    const Vec2 q = delaunay_.site_position(delaunay_.edge(edge).v[1]);
    const Vec2 center = filter_.kept_end(edge, end_of(row));
    return {center, distance(center, lexicographically_less(p, q) ? p : q)};
  }
  bool is_from_samples() const override { return false; }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    const Vec2 center = plain_disk(row).center;
    return {center, center, center};
  }
  void touched_samples(FamilySlot, std::vector<TouchedSample>&) const override {}
  bool has_changed() const override {
    return !filter_.node_changes().is_empty() || !filter_.edge_changes().is_empty();
  }

 private:
  static int end_of(FamilySlot row) { return static_cast<int>(row.index() / 2 % 2); }

  const AxisFilter& filter_;
  const Delaunay& delaunay_;
};

}  // namespace

KeptUnion::KeptUnion(std::string_view id, SettingsSource& settings, Delaunay& delaunay, Labels& labels,
                     InnerBalls& balls, AxisFilter& filter)
    : BallUnion(id, {&settings, &delaunay, &labels, &balls, &filter}, settings, Parameter::a_scale,
                std::make_unique<KeptBalls>(filter)),
      delaunay_(delaunay),
      labels_(labels),
      filter_(filter) {}

double KeptUnion::shape_area() const {
  Sum out;
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(face) || !labels_.is_inside(face)) continue;
    const FaceRow& row = delaunay_.face(face);
    const Vec2 a = delaunay_.site_position(row.v[0]);
    out.add(0.5 * cross(delaunay_.site_position(row.v[1]) - a, delaunay_.site_position(row.v[2]) - a));
    for (int i = 0; i < 3; ++i) {
      if (labels_.is_inside(row.n[i])) continue;
      // The angle at the corner opposite is half that at the centre.
      const double half = angle_at(delaunay_.site_position(row.v[i]), delaunay_.site_position(row.v[next3(i)]),
                                   delaunay_.site_position(row.v[prev3(i)])) *
                          (std::numbers::pi / 180.0);
      out.add(row.radius * row.radius * (half - std::sin(half) * std::cos(half)));
    }
  }
  return out.value();
}

StatList KeptUnion::statistics() const {
  StatList out = BallUnion::statistics();
  const double shape = shape_area();
  const double share = tables().measures.area / shape;
  out.push_back({"shape_area", shape});
  if (shape > 0.0 && std::isfinite(share) && family().scale() == 1.0) out.push_back({"share_of_shape", share});
  return out;
}

void KeptUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FamilySlot ball(row);
  if (kind != ElementKind::ball) return BallUnion::explain(kind, row, out);
  if (!tables().balls.has(ball) || !family().is_ball(ball)) return;
  if (row % 2 == 0)
    out.about(ElementKind::voronoi_vertex, FaceSlot(row / 2));
  else
    out.about(ElementKind::delaunay_edge, EdgeSlot(row / 4));
  explain_scale(ball, out);
  explain_place(ball, out);
}

}  // namespace mes

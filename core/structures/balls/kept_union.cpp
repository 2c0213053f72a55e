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
  // A ball about a point of an edge touches both samples; its radius is the distance to the smaller one.
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
      balls_(balls),
      filter_(filter) {}

double KeptUnion::segment_area(const FaceRow& row, int i) const {
  const Vec2 q = delaunay_.site_position(row.v[next3(i)]);
  const Vec2 r = delaunay_.site_position(row.v[prev3(i)]);
  // The angle at the opposite corner is half that at the centre. The chord is used instead of the radius, which may be
  // beyond the range of doubles where the segment is not.
  const double half = angle_at(delaunay_.site_position(row.v[i]), q, r) * (std::numbers::pi / 180.0);
  const double sine = std::sin(half);
  const double chord = distance(q, r);
  const double shape = half < 1e-4 ? (2.0 / 3.0) * half : (half - sine * std::cos(half)) / (sine * sine);
  return 0.25 * chord * chord * shape;
}

StatList KeptUnion::statistics() const {
  constexpr double kDigits = 1e9;  // digits that rounding leaves of the area of the balls
  StatList out = BallUnion::statistics();
  Sum shape;
  Sum beyond;
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(face) || !labels_.is_inside(face)) continue;
    const FaceRow& row = delaunay_.face(face);
    const Vec2 a = delaunay_.site_position(row.v[0]);
    shape.add(0.5 * cross(delaunay_.site_position(row.v[1]) - a, delaunay_.site_position(row.v[2]) - a));
    if (!filter_.is_kept(balls_.ball(face))) continue;
    for (int i = 0; i < 3; ++i)
      if (!labels_.is_inside(row.n[i])) beyond.add(segment_area(row, i));
  }
  out.push_back({"shape_area", shape.value()});
  const double area = tables().measures.area;
  if (!(shape.value() > 0.0) || !(area < kDigits * shape.value()) || family().scale() != 1.0) return out;
  const double share = (area - beyond.value()) / shape.value();
  if (std::isfinite(share)) out.push_back({"share_of_shape", std::clamp(share, 0.0, 1.0)});
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

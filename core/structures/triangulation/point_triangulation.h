// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay triangulation of points, as plain tables.
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <optional>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/table.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/kernels.h"
#include "core/structures/triangulation/hilbert.h"
#include "core/structures/triangulation/input_slots.h"

namespace mes {

/// Equal points are represented by one of them.
struct PointTriangulation {
  /// A finite triangle. Corners run counter-clockwise; neighbour i lies opposite corner i, kNoSlot outside.
  struct Face {
    InputSlot v[3]{};
    TriangleSlot n[3]{};
  };
  int dimension = -1;
  Table<InputSlot, InputSlot> same_as;
  Table<TriangleSlot, Face> faces;
  std::vector<std::array<InputSlot, 2>> line;  ///< edges, if all points are collinear
};

/// O(n log n) typically, if consecutive points are close. Decisions are those of the kernel. Kernels whose numbers
/// belong to one thread use CGAL.
template <class Kernel>
PointTriangulation point_triangulation(const Table<InputSlot, typename Kernel::Point_2>& points, JobControl& job) {
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<InputSlot, Kernel>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<TriangleSlot, Kernel>;
  using Dt = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

  PointTriangulation out;
  out.same_as.resize(points.size());
  Dt dt;
  typename Dt::Face_handle hint{};
  std::size_t done = 0;
  std::vector<InputSlot> order = in_rounds<InputSlot>(points.size());
  using Point = typename Kernel::Point_2;
  leave_line_early(
      order, [&](InputSlot i) { return points[i]; },
      [](const Point& a, const Point& b, const Point& c) { return typename Kernel::Orientation_2()(a, b, c); },
      typename Kernel::Less_xy_2());
  for (const InputSlot i : order) {
    if ((++done & 0x3fU) == 0) job.checkpoint(done, points.size());
    const std::size_t before = dt.number_of_vertices();
    const auto vertex = dt.insert(points[i], hint);
    if (dt.number_of_vertices() != before) vertex->info() = i;
    out.same_as[i] = vertex->info();
    hint = vertex->face();
  }
  out.dimension = dt.dimension();
  if (out.dimension == 1) {
    for (auto e = dt.finite_edges_begin(); e != dt.finite_edges_end(); ++e)
      out.line.push_back({e->first->vertex(Dt::ccw(e->second))->info(), e->first->vertex(Dt::cw(e->second))->info()});
  }
  if (out.dimension < 2) return out;
  for (auto f = dt.all_faces_begin(); f != dt.all_faces_end(); ++f) f->info() = kNoSlot;
  TriangleSlot end{0};
  for (auto f = dt.finite_faces_begin(); f != dt.finite_faces_end(); ++f, ++end) f->info() = end;
  out.faces.reserve(end.index());
  for (auto f = dt.finite_faces_begin(); f != dt.finite_faces_end(); ++f) {
    PointTriangulation::Face& face = out.faces.emplace_back();
    for (int i = 0; i < 3; ++i) {
      face.v[i] = f->vertex(i)->info();
      face.n[i] = f->neighbor(i)->info();
    }
  }
  return out;
}

/// O(n log n) in any order, on all cores; 0.3 us per point on one. The result depends on the points and their order
/// alone.
template <>
PointTriangulation point_triangulation<FastKernel>(const Table<InputSlot, FastKernel::Point_2>& points,
                                                   JobControl& job);

/// Regular triangulation of balls in the same way. Returns nothing if a ball is hidden by others about other centres,
/// if three centres along an intermediate hull are collinear, or if fewer than three centres differ. `same_as` is the
/// largest ball about the same centre; kNoSlot where all of these are left out.
std::optional<PointTriangulation> ball_triangulation(const Table<InputSlot, BallOf<double>>& balls,
                                                     const Table<InputSlot, bool>& left_out, JobControl& job);

}  // namespace mes

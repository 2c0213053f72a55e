// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/raw_delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>
#include <utility>
#include <vector>

namespace mes::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

struct RawDelaunay::Impl {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertex;
};

RawDelaunay::RawDelaunay() : impl_(std::make_unique<Impl>()) {}
RawDelaunay::~RawDelaunay() = default;

void RawDelaunay::insert_range(std::span<const Vec2> points) {
  std::vector<Kernel::Point_2> cgal_points;
  cgal_points.reserve(points.size());
  for (const Vec2 p : points) cgal_points.emplace_back(p.x, p.y);
  impl_->triangulation.insert(cgal_points.begin(), cgal_points.end());
}

void RawDelaunay::insert_range_and_index(std::span<const Vec2> points) {
  insert_range(points);
  std::map<std::pair<double, double>, Triangulation::Vertex_handle> at;
  for (const auto v : impl_->triangulation.finite_vertex_handles()) at[{v->point().x(), v->point().y()}] = v;
  for (const Vec2 p : points) impl_->vertex.push_back(at[{p.x, p.y}]);
  impl_->vertex.emplace_back();  // one more index, for a sample to come
}

void RawDelaunay::move(std::size_t index, Vec2 to) {
  impl_->vertex[index] = impl_->triangulation.move_if_no_collision(impl_->vertex[index], {to.x, to.y});
}

void RawDelaunay::remove(std::size_t index) {
  impl_->triangulation.remove(impl_->vertex[index]);
}

void RawDelaunay::insert_near(std::size_t index, Vec2 at, std::size_t hint) {
  impl_->vertex[index] = impl_->triangulation.insert({at.x, at.y}, impl_->vertex[hint]->face());
}

}  // namespace mes::bench

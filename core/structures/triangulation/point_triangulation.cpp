// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/triangulation/point_triangulation.h"

#include <atomic>
#include <bit>
#include <cstdint>

#include "core/base/jobs/parallel.h"
#include "core/kernel/kernels.h"
#include "core/structures/triangulation/point_joiner.h"

namespace mes {
namespace {

using point_joiner::Joiner;
using point_joiner::PlaceSlot;
using Point = FastKernel::Point_2;

/// For each point, the first of the points equal to it.
Table<InputSlot, InputSlot> first_of_equals(const Table<InputSlot, Point>& points) {
  Table<InputSlot, InputSlot> out(points.size());
  const unsigned bits = static_cast<unsigned>(std::bit_width(2 * points.size()));
  std::vector<InputSlot> table(std::size_t{1} << bits);
  const auto key = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // both zeros get one key
  for (const InputSlot i : points.rows()) {
    // Multiplies by odd constants without a pattern; the high bits depend on all others.
    const std::uint64_t mixed =
        (key(points[i].x()) * 0x9e3779b97f4a7c15U) ^ (key(points[i].y()) * 0xc2b2ae3d27d4eb4fU);
    std::size_t place = (mixed * 0x9e3779b97f4a7c15U) >> (64U - bits);
    while (table[place] != kNoSlot && points[table[place]] != points[i]) place = (place + 1) & (table.size() - 1);
    if (table[place] == kNoSlot) table[place] = i;
    out[i] = table[place];
  }
  return out;
}

/// Counter-clockwise triangles within a convex boundary cover its inside once. If the power test then holds between
/// each triangle and its neighbours, it holds everywhere.
bool is_regular(const PointTriangulation& triangulation, const Table<InputSlot, BallOf<double>>& balls) {
  const auto& faces = triangulation.faces;
  const auto center = [&balls](InputSlot ball) { return Point(balls[ball].x, balls[ball].y); };
  std::atomic<bool> is_wrong = false;
  parallel_for(faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const TriangleSlot f : slots_between<TriangleSlot>(begin, end)) {
      if (is_wrong) break;
      const auto& v = faces[f].v;
      if (!CGAL::left_turn(center(v[0]), center(v[1]), center(v[2]))) is_wrong = true;
      for (const TriangleSlot g : faces[f].n) {
        if (g == kNoSlot || g < f) continue;
        const auto& n = faces[g].n;
        const InputSlot apex = faces[g].v[n[0] == f ? 0 : (n[1] == f ? 1 : 2)];
        if (sign_of_excess_at_center<FastKernel>(balls[v[0]], balls[v[1]], balls[v[2]], balls[apex]) < 0)
          is_wrong = true;
      }
    }
  });
  Table<InputSlot, bool> is_seen(balls.size(), false);
  for (const auto& face : faces)
    for (const InputSlot v : face.v) is_seen[v] = true;
  for (const InputSlot i : balls.rows())
    if (triangulation.same_as[i] == i && !is_seen[i]) return false;
  return !is_wrong;
}

}  // namespace

template <>
PointTriangulation point_triangulation<FastKernel>(const Table<InputSlot, Point>& points, JobControl& job) {
  PointTriangulation out;
  out.same_as = first_of_equals(points);
  Table<PlaceSlot, Joiner<FastKernel>::Placed> distinct;
  distinct.reserve(points.size());
  for (const InputSlot i : points.rows())
    if (out.same_as[i] == i) distinct.push_back({points[i], 0.0, i});
  out.dimension = distinct.empty() ? -1 : 0;
  if (distinct.size() < 2) return out;
  Joiner<FastKernel> joiner(std::move(distinct), false, job);
  joiner.run();
  joiner.extract(out);
  return out;
}

std::optional<PointTriangulation> ball_triangulation(const Table<InputSlot, BallOf<double>>& balls,
                                                     const Table<InputSlot, bool>& left_out, JobControl& job) {
  Table<InputSlot, Point> centers;
  centers.reserve(balls.size());
  for (const BallOf<double>& ball : balls) centers.emplace_back(ball.x, ball.y);
  const Table<InputSlot, InputSlot> first = first_of_equals(centers);
  // Among balls about one centre, only the largest takes part.
  PointTriangulation out;
  out.same_as.assign(balls.size(), kNoSlot);
  const auto is_in = [&](InputSlot i) { return left_out.empty() || !left_out[i]; };
  for (const InputSlot i : balls.rows()) {
    InputSlot& largest = out.same_as[first[i]];
    if (is_in(i) && (largest == kNoSlot || balls[largest].w < balls[i].w)) largest = i;
  }
  for (const InputSlot i : balls.rows())
    if (first[i] != i) out.same_as[i] = out.same_as[first[i]];
  Table<PlaceSlot, Joiner<FastKernel>::Placed> distinct;
  distinct.reserve(balls.size());
  for (const InputSlot i : balls.rows())
    if (out.same_as[i] == i) distinct.push_back({centers[i], balls[i].w, i});
  if (distinct.size() < 3) return std::nullopt;
  Joiner<FastKernel> joiner(std::move(distinct), true, job);
  if (!joiner.run() || !joiner.extract(out)) return std::nullopt;
  return is_regular(out, balls) ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace mes

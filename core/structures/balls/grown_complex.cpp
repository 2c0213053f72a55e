// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/grown_complex.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/geometry/angle.h"

namespace mes {

GrownComplex::GrownComplex(std::string_view id, SettingsSource& settings, BallFiltration& filtration)
    : Structure(id, {&settings, &filtration}), settings_(settings), filtration_(filtration) {}

Disk GrownComplex::disk(GrownCornerSlot corner) const {
  const Disk& plain = filtration_.disk(corner);
  return {plain.center, std::hypot(plain.radius, growth_)};
}

void GrownComplex::find_ways() {
  hull_edge_.assign(filtration_.corners().size(), {});
  const bool is_line = filtration_.triangles().empty();
  for (const GrownEdgeSlot e : filtration_.edges().rows()) {
    const BallBirths::Edge& edge = filtration_.edges()[e];
    for (std::size_t i = 0; i < 2; ++i) {
      auto& there = hull_edge_[edge.v[i]];
      if (is_line)
        there[there[0] == kNoSlot ? 0 : 1] = e;
      else if (edge.f[1 - i] == kNoSlot)
        there[0] = e;
    }
  }
}

void GrownComplex::set_growth() {
  growth_ = wish();
  come_ = filtration_.ranks_within(growth_);
  has_edge_.assign(filtration_.corners().size(), false);
  for (const GrownEdgeSlot edge : filtration_.edges().rows()) {
    if (!holds(edge)) break;
    for (const GrownCornerSlot corner : filtration_.edges()[edge].v) has_edge_[corner] = true;
  }
}

void GrownComplex::rebuild(JobControl&) {
  clear_changes();
  find_ways();
  set_growth();
}

bool GrownComplex::update(JobControl&) {
  clear_changes();
  if (wish() == growth_) return true;
  const std::uint32_t before = come_;
  set_growth();
  const auto [low, high] = std::minmax(before, come_);
  // Rows are in the order of their ranks.
  const auto add_between = [low = low, high = high](const auto& rows, auto& changes) {
    const auto reaches = [](std::uint32_t limit) { return [limit](const auto& row) { return row.rank < limit; }; };
    const auto first = std::ranges::partition_point(rows.values(), reaches(low)) - rows.values().begin();
    const auto last = std::ranges::partition_point(rows.values(), reaches(high)) - rows.values().begin();
    for (auto i = first; i < last; ++i) changes.touched.emplace_back(static_cast<std::size_t>(i));
  };
  add_between(filtration_.edges(), edge_changes_);
  add_between(filtration_.triangles(), triangle_changes_);
  for (const GrownCornerSlot corner : filtration_.corners().rows()) corner_changes_.touched.push_back(corner);
  for (const GrownEdgeSlot edge : filtration_.edges().rows()) {
    if (filtration_.edges()[edge].rank >= high) break;
    for (std::size_t i = 0; i < 2; ++i) end_changes_.touched.emplace_back(2 * edge.index() + i);
  }
  const auto& classes = filtration_.classes();
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (is_alive(classes[i]) || (classes[i].birth < before && before <= classes[i].death))
      class_changes_.touched.emplace_back(i);
  return true;
}

void GrownComplex::clear_changes() {
  corner_changes_.clear();
  edge_changes_.clear();
  triangle_changes_.clear();
  end_changes_.clear();
  class_changes_.clear();
}

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Counter-clockwise angle from `a` to `b`, which is less than half a turn exactly if a triangle lies between them.
double turn_between(Vec2 a, Vec2 b, bool is_triangle) {
  // Rounding carries an angle beyond the ends of its range, but never half as far.
  const double turn = angle_of({dot(a, b), cross(a, b)});
  if (is_triangle) return turn < -0.5 * kHalfTurn ? kHalfTurn : std::max(0.0, turn);
  return turn < 0.5 * kHalfTurn ? turn + 2.0 * kHalfTurn : turn;
}

GrownEdgeSlot edge_of(GrownEndSlot end) {
  return GrownEdgeSlot(end.index() / 2);
}
GrownEndSlot other_end(GrownEndSlot end) {
  return GrownEndSlot(end.index() ^ 1U);
}

}  // namespace

double GrownComplex::half_chord(GrownEdgeSlot edge) const {
  const BallBirths::Edge& row = filtration_.edges()[edge];
  const BallPair ends{filtration_.corners()[row.v[0]].ball, filtration_.corners()[row.v[1]].ball};
  return mes::half_chord(filtration_.balls(), ends, row.axis, growth_);
}

Vec2 GrownComplex::crossing(GrownEndSlot end) const {
  const GrownEdgeSlot edge = edge_of(end);
  const BallBirths::Edge& row = filtration_.edges()[edge];
  // Both arcs that meet there start from the centre of the smaller ball, so that they have the same bits.
  const auto size_of = [&](std::size_t i) {
    return std::pair(filtration_.disk(row.v[i]).radius, filtration_.corners()[row.v[i]].ball);
  };
  const std::size_t from = size_of(0) < size_of(1) ? 0 : 1;
  const bool is_left = end.index() % 2 == from;
  const Vec2 along = direction(GrownEndSlot(2 * edge.index() + from));
  const double half = half_chord(edge);
  const Vec2 way = row.axis.foot[from] * along + (is_left ? half : -half) * perpendicular(along);
  return filtration_.disk(row.v[from]).center + filtration_.balls().frame.vector_to_document(way);
}

double GrownComplex::half_angle(GrownEndSlot end) const {
  const GrownEdgeSlot edge = edge_of(end);
  return angle_of({filtration_.edges()[edge].axis.foot[end.index() % 2], half_chord(edge)});
}

Vec2 GrownComplex::direction(GrownEndSlot end) const {
  const Vec2 along = filtration_.edges()[edge_of(end)].axis.direction;
  return end.index() % 2 == 0 ? along : -along;
}

GrownComplex::Spoke GrownComplex::next_held(GrownEndSlot from) const {
  const GrownEdgeSlot edge = edge_of(from);
  const GrownCornerSlot corner = filtration_.edges()[edge].v[from.index() % 2];
  if (filtration_.triangles().empty()) {
    for (const GrownEdgeSlot other : hull_edge_[corner])
      if (other != kNoSlot && other != edge && holds(other)) return {end_at(corner, other), kHalfTurn};
    return {from, 2.0 * kHalfTurn};
  }
  Spoke out{from, 0.0};
  for (GrownTriangleSlot at = filtration_.edges()[edge].f[from.index() % 2];;) {
    const bool is_triangle = at != kNoSlot;
    GrownEdgeSlot next;
    if (is_triangle) {
      const BallBirths::Triangle& row = filtration_.triangles()[at];
      const std::size_t i = row.v[0] == corner ? 0 : (row.v[1] == corner ? 1 : 2);
      next = row.e[(i + 1) % 3];
      at = row.n[(i + 1) % 3];
    } else {
      next = hull_edge_[corner][0];
      const BallBirths::Edge& row = filtration_.edges()[next];
      at = row.f[row.v[0] == corner ? 0 : 1];
    }
    if (next == edge) return {from, 2.0 * kHalfTurn};
    const GrownEndSlot end = end_at(corner, next);
    out = {end, out.turn + turn_between(direction(out.end), direction(end), is_triangle)};
    if (holds(next)) return out;
  }
}

std::optional<BoundaryArc> GrownComplex::arc(GrownEndSlot row) const {
  const GrownEdgeSlot edge = edge_of(row);
  if (!holds(edge)) return std::nullopt;
  const BallBirths::Edge& ends = filtration_.edges()[edge];
  const std::size_t i = row.index() % 2;
  if (!is_open(ends.f[i])) return std::nullopt;
  const Spoke next = next_held(row);
  // The crossing to the right of the next edge is the one to its left, seen from its other end.
  return BoundaryArc{filtration_.ball(ends.v[i]), 0, crossing(row), crossing(other_end(next.end)),
                     std::max(0.0, next.turn - half_angle(row) - half_angle(next.end))};
}

std::optional<Arc> GrownComplex::drawn(GrownEndSlot row) const {
  const auto found = arc(row);
  if (!found) return std::nullopt;
  const Disk ball = disk(filtration_.edges()[edge_of(row)].v[row.index() % 2]);
  return ball.radius > 0.0 ? drawn_arc(*found, ball) : std::nullopt;
}

StatList GrownComplex::statistics() const {
  const auto held = [this](const auto& rows) {
    return static_cast<std::int64_t>(
        std::ranges::count_if(rows.values(), [this](const auto& row) { return row.rank < come_; }));
  };
  std::int64_t components = 0;
  std::int64_t holes = 0;
  for (const BallFiltration::Class& one : filtration_.classes())
    if (is_alive(one)) ++(one.is_hole ? holes : components);
  return {{"balls", held(filtration_.corners())},
          {"edges", held(filtration_.edges())},
          {"triangles", held(filtration_.triangles())},
          {"components", components},
          {"holes", holes}};
}

}  // namespace mes

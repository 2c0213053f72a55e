// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/grown_complex.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Two circles whose squared radii grow by one number.
struct CrossingCircles {
  double apart = 0.0;   ///< distance of the centres
  double foot = 0.0;    ///< from the first centre to the line through the crossings
  double height = 0.0;  ///< of a crossing above the line of the centres

  CrossingCircles(const Disk& first, const Disk& second, double growth) {
    apart = distance(first.center, second.center);
    if (!(apart > 0.0)) return;
    const double radius = std::hypot(first.radius, growth);
    foot = 0.5 * apart + 0.5 * ((first.radius - second.radius) / apart) * (first.radius + second.radius);
    // One root of the product: those of both factors would be rounded otherwise in other units.
    height = std::sqrt(std::max(0.0, radius - std::abs(foot)) * (radius + std::abs(foot)));
  }
};

}  // namespace

Vec2 GrownComplex::crossing(GrownCornerSlot from, GrownCornerSlot to) const {
  const Disk& p = filtration_.disk(from);
  const Disk& q = filtration_.disk(to);
  // From the first centre on, so that both arcs that meet there have it to the last bit.
  const bool is_turned = lexicographically_less(q.center, p.center);
  const Disk& first = is_turned ? q : p;
  const Disk& second = is_turned ? p : q;
  const CrossingCircles circles(first, second, growth_);
  if (!(circles.apart > 0.0)) return p.center;
  const Vec2 along = second.center - first.center;
  const double forth = circles.foot / circles.apart;
  const double side = (is_turned ? -circles.height : circles.height) / circles.apart;
  return {first.center.x + forth * along.x - side * along.y, first.center.y + forth * along.y + side * along.x};
}

double GrownComplex::half_angle(GrownCornerSlot from, GrownCornerSlot to) const {
  const CrossingCircles circles(filtration_.disk(from), filtration_.disk(to), growth_);
  return std::atan2(circles.height, circles.foot);
}

GrownCornerSlot GrownComplex::next_held(GrownCornerSlot corner, GrownEdgeSlot edge, GrownTriangleSlot left) const {
  const auto other_end = [&](GrownEdgeSlot at) {
    const auto& v = filtration_.edges()[at].v;
    return v[v[0] == corner ? 1 : 0];
  };
  if (filtration_.triangles().empty()) {
    for (const GrownEdgeSlot other : hull_edge_[corner])
      if (other != kNoSlot && other != edge && holds(other)) return other_end(other);
    return other_end(edge);
  }
  for (GrownTriangleSlot at = left;;) {
    GrownEdgeSlot next;
    if (at == kNoSlot) {
      next = hull_edge_[corner][0];
      const BallBirths::Edge& row = filtration_.edges()[next];
      at = row.f[row.v[0] == corner ? 0 : 1];
    } else {
      const BallBirths::Triangle& row = filtration_.triangles()[at];
      const std::size_t i = row.v[0] == corner ? 0 : (row.v[1] == corner ? 1 : 2);
      next = row.e[(i + 1) % 3];
      at = row.n[(i + 1) % 3];
    }
    if (holds(next)) return other_end(next);
  }
}

std::optional<Arc> GrownComplex::arc(GrownEndSlot row) const {
  const GrownEdgeSlot edge(row.index() / 2);
  if (!holds(edge)) return std::nullopt;
  const BallBirths::Edge& ends = filtration_.edges()[edge];
  const std::size_t i = row.index() % 2;
  if (!is_open(ends.f[i])) return std::nullopt;
  const GrownCornerSlot corner = ends.v[i];
  const GrownCornerSlot other = ends.v[1 - i];
  const GrownCornerSlot next = next_held(corner, edge, ends.f[i]);
  // To the right of the next edge, which is to the left of it seen from its other end.
  const Arc out{filtration_.disk(corner).center, disk(corner).radius, crossing(corner, other),
                crossing(next, corner)};
  // One that is shorter than its ends are rounded may have them the wrong way round, or in one place, and then goes
  // nearly all the way about the centre.
  const Vec2 center = out.center;
  const double between = next == other
                             ? 2.0 * std::numbers::pi
                             : sweep_of({center, 1.0, filtration_.disk(other).center, filtration_.disk(next).center});
  const double wanted = between - half_angle(corner, other) - half_angle(corner, next);
  if (sweep_of(out) > wanted + std::numbers::pi) return std::nullopt;
  return out;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/alpha/alpha_complex.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/kernel/numbers/two_doubles.h"

namespace mes {

AlphaComplex::AlphaComplex(SettingsSource& settings, Delaunay& delaunay, AlphaFiltration& filtration)
    : Structure("alpha-complex", {&settings, &delaunay, &filtration}),
      settings_(settings),
      delaunay_(delaunay),
      filtration_(filtration) {}

void AlphaComplex::set_radius() {
  radius_ = wish();
  last_ = filtration_.last_rank(radius_);
  is_alone_.assign(delaunay_.site_rows(), 1);
  for (const EdgeSlot edge : filtration_.edges()) {
    if (!holds(edge)) break;
    for (const SiteSlot site : delaunay_.edge(edge).v) is_alone_[site] = 0;
  }
}

void AlphaComplex::rebuild(JobControl&) {
  clear_changes();
  set_radius();
}

bool AlphaComplex::update(JobControl&) {
  clear_changes();
  if (wish() == radius_) return true;
  const std::uint32_t before = last_;
  set_radius();
  const auto [low, high] = std::minmax(before, last_);
  const auto add_between = [&](const auto& rows, auto& changes) {
    auto at = std::ranges::upper_bound(rows, low, {}, [this](auto row) { return filtration_.rank(row); });
    for (; at != rows.end() && filtration_.rank(*at) <= high; ++at) changes.touched.push_back(*at);
  };
  add_between(filtration_.edges(), edge_changes_);
  add_between(filtration_.faces(), face_changes_);
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) site_changes_.touched.push_back(site);
  for (const EdgeSlot edge : filtration_.edges()) {
    if (filtration_.rank(edge) > high) break;
    for (std::size_t i = 0; i < 2; ++i) end_changes_.touched.push_back(EdgeEndSlot(2 * edge.index() + i));
  }
  const auto& classes = filtration_.classes();
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (is_alive(classes[i]) || (classes[i].birth <= before && before < classes[i].death))
      class_changes_.touched.push_back(ClassSlot(i));
  return true;
}

void AlphaComplex::clear_changes() {
  edge_changes_.clear();
  face_changes_.clear();
  site_changes_.clear();
  end_changes_.clear();
  class_changes_.clear();
}

Vec2 AlphaComplex::crossing(SiteSlot site, SiteSlot other) const {
  const Vec2 p = delaunay_.site_position(site);
  const Vec2 q = delaunay_.site_position(other);
  // Starts from the smaller end, so that both arcs that meet at the crossing have the same bits.
  const bool is_turned = lexicographically_less(q, p);
  const Vec2 first = is_turned ? q : p;
  const Vec2 along = is_turned ? p - q : q - p;
  const double size = length(along);
  // Twice the digits: half of them cancel where circles all but touch.
  const TwoDoubles x = TwoDoubles::difference(p.x, q.x), y = TwoDoubles::difference(p.y, q.y);
  const TwoDoubles square = TwoDoubles(radius_) * TwoDoubles(radius_) - TwoDoubles(0.25) * (x * x + y * y);
  const double height = std::sqrt(std::max(0.0, square.value()));
  const double side = (is_turned ? -height : height) / size;
  return {first.x + 0.5 * along.x - side * along.y, first.y + 0.5 * along.y + side * along.x};
}

SiteSlot AlphaComplex::next_held(SiteSlot site, EdgeSlot edge, FaceSlot left) const {
  if (delaunay_.dimension() < 2) {
    // The site has at most one other held edge.
    SiteSlot out = kNoSlot;
    SiteSlot own = kNoSlot;
    delaunay_.for_each_edge_at(site, [&](EdgeSlot at, SiteSlot end, FaceSlot) {
      if (holds(at)) (at == edge ? own : out) = end;
    });
    return out == kNoSlot ? own : out;
  }
  for (FaceSlot at = left;;) {
    const FaceRow& row = delaunay_.face(at);
    const int i = row.index_of_site(site);
    if (const EdgeSlot next = row.e[next3(i)]; next != kNoSlot && holds(next)) return row.v[prev3(i)];
    at = row.n[next3(i)];
  }
}

std::optional<Arc> AlphaComplex::arc(EdgeEndSlot row) const {
  const EdgeSlot edge(row.index() / 2);
  if (!delaunay_.edge(edge).is_alive() || !holds(edge)) return std::nullopt;
  const EdgeRow& ends = delaunay_.edge(edge);
  const bool is_second = row.index() % 2 != 0;
  const SiteSlot site = ends.v[is_second ? 1 : 0];
  const SiteSlot other = ends.v[is_second ? 0 : 1];
  const FaceSlot left = ends.f[is_second ? 1 : 0];
  if (!is_open(left)) return std::nullopt;
  const SiteSlot next = next_held(site, edge, left);
  const Vec2 from = crossing(site, other);
  // The crossing to the right of the next edge is the one to its left, seen from its other end.
  const Vec2 to = crossing(next, site);
  // The ends coincide where circles touch. A circle that touches only one other keeps its whole boundary; otherwise the
  // arc has length zero, and equal ends would mean the whole circle.
  if (from == to && next != other) return std::nullopt;
  const Vec2 center = delaunay_.site_position(site);
  const Arc out{center, radius_, from, to};
  // The arc lies between the two edges. Rounding may exchange the ends of an arc shorter than the rounding error, which
  // then goes nearly all the way around the centre.
  if (next != other) {
    const double between = sweep_of({center, 1.0, delaunay_.site_position(other), delaunay_.site_position(next)});
    if (sweep_of(out) > 0.5 * between + std::numbers::pi) return std::nullopt;
  }
  return out;
}

StatList AlphaComplex::statistics() const {
  std::int64_t edges = 0;
  std::int64_t triangles = 0;
  std::int64_t components = 0;
  std::int64_t holes = 0;
  for (const EdgeSlot edge : filtration_.edges()) edges += holds(edge) ? 1 : 0;
  for (const FaceSlot face : filtration_.faces()) triangles += holds(face) ? 1 : 0;
  for (const AlphaFiltration::Class& one : filtration_.classes())
    if (is_alive(one)) ++(one.is_hole ? holes : components);
  return {{"edges", edges}, {"triangles", triangles}, {"components", components}, {"holes", holes}};
}

}  // namespace mes

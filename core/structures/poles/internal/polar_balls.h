// SPDX-License-Identifier: GPL-3.0-or-later
// The polar balls, with a large ball for each pole at infinity.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/geometry/box2.h"
#include "core/structures/balls/voronoi_balls.h"
#include "core/structures/poles/poles.h"

namespace mes {

/// A ball around a pole at infinity is the half plane beyond the sample, but power diagrams need balls. So a hull
/// sample gets a ball through the sample, in the direction of its pole, whose size is `kReach` times the extent of all
/// samples. Rows: faces, then sites for these balls. `measure` must be called after each change.
class PolarBalls final : public VoronoiBalls {
 public:
  PolarBalls(const Delaunay& delaunay, const VoronoiVertices& vertices, const Poles& poles)
      : VoronoiBalls(delaunay, vertices), poles_(poles) {}

  void measure() {
    Box2 box;
    for (const SiteSlot site : delaunay_.site_slots())
      if (delaunay_.is_site(site)) box.add(delaunay_.site_position(site));
    const double extent = box.is_empty() ? 1.0 : std::max(box.width(), box.height());
    // A power of two, so that the balls stay the same while the extent changes little.
    reach_ = std::ldexp(kReach, std::isfinite(extent) && extent > 0.0 ? std::ilogb(extent) : 0);
  }

  bool is_at_infinity(FamilySlot row) const { return row.index() >= delaunay_.face_rows(); }
  FamilySlot row_at_infinity(SiteSlot site) const { return FamilySlot(delaunay_.face_rows() + site.index()); }

  std::size_t rows() const override { return delaunay_.face_rows() + delaunay_.site_rows(); }
  std::string_view rows_of() const override { return {}; }
  bool is_ball(FamilySlot row) const override {
    if (delaunay_.dimension() < 2) return false;
    if (!is_at_infinity(row)) return delaunay_.face(face_of(row)).is_alive() && poles_.is_pole(face_of(row));
    return delaunay_.is_site(site_of(row)) && poles_.plus(site_of(row)) == kInfinitePole;
  }
  Disk plain_disk(FamilySlot row) const override {
    if (!is_at_infinity(row)) return VoronoiBalls::plain_disk(row);
    const Vec2 p = delaunay_.site_position(site_of(row));
    const Vec2 center = p + reach_ * poles_.direction_to_infinity(site_of(row));
    return {center, distance(center, p)};
  }
  BallOrigin origin(FamilySlot row) const override {
    return is_at_infinity(row) ? BallOrigin::through_sample : BallOrigin::circumdisk;
  }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    if (!is_at_infinity(row)) return VoronoiBalls::corners(row);
    const Vec2 p = delaunay_.site_position(site_of(row));
    return {p, p, p};
  }
  void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const override {
    if (!is_at_infinity(row)) return VoronoiBalls::touched_samples(row, out);
    out.push_back({site_of(row), delaunay_.site_position(site_of(row))});
  }
  bool has_changed() const override { return !poles_.face_changes().is_empty(); }

 private:
  static constexpr double kReach = 4096.0;
  SiteSlot site_of(FamilySlot row) const { return SiteSlot(row.index() - delaunay_.face_rows()); }

  const Poles& poles_;
  double reach_ = 1.0;
};

}  // namespace mes

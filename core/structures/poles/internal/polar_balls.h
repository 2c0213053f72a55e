// SPDX-License-Identifier: GPL-3.0-or-later
// The polar balls, with large balls for poles at infinity or far away.
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
/// samples. A pole farther away than that, as three samples on one side of a polygon have if rounding bends the side,
/// is represented likewise, by a ball for each of its samples: such a ball lies in the one about the pole, so it holds
/// no sample, and doubles still say where its circle runs.
///
/// Rows: faces, then sites with the balls for far plus poles, then sites with those for far minus poles. `measure` must
/// be called after each change.
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

  /// True for a ball that represents a pole at infinity, or beyond the reach.
  bool is_far(FamilySlot row) const { return row.index() >= delaunay_.face_rows(); }
  /// The pole of the ball: a face, `kInfinitePole`, or kNoSlot in a row without a ball.
  FaceSlot pole_of(FamilySlot row) const {
    if (!is_far(row)) return face_of(row);
    const SiteSlot site = site_of(row);
    return row == row_of(site, 0) ? poles_.plus(site) : poles_.minus(site);
  }
  /// The ball that represents the plus pole of the site, or its minus pole; kNoSlot if it has none.
  FamilySlot ball_of_plus(SiteSlot site) const { return ball_of(site, poles_.plus(site), 0); }
  FamilySlot ball_of_minus(SiteSlot site) const { return ball_of(site, poles_.minus(site), 1); }
  /// Unit vector from the site towards its pole.
  Vec2 direction_to(FaceSlot pole, SiteSlot site) const {
    if (pole == kInfinitePole) return poles_.direction_to_infinity(site);
    const Vec2 to = delaunay_.circumcenter(pole) - delaunay_.site_position(site);
    const double size = length(to);
    return {to.x / size, to.y / size};
  }

  std::size_t rows() const override { return delaunay_.face_rows() + 2 * delaunay_.site_rows(); }
  std::string_view rows_of() const override { return {}; }
  bool is_ball(FamilySlot row) const override {
    if (delaunay_.dimension() < 2) return false;
    if (!is_far(row)) {
      const FaceSlot face = face_of(row);
      return delaunay_.face(face).is_alive() && poles_.is_pole(face) && !is_beyond_reach(face);
    }
    if (!delaunay_.is_site(site_of(row))) return false;
    const FaceSlot pole = pole_of(row);
    return pole != kNoSlot && is_beyond_reach(pole);
  }
  Disk plain_disk(FamilySlot row) const override {
    if (!is_far(row)) return VoronoiBalls::plain_disk(row);
    const SiteSlot site = site_of(row);
    const Vec2 p = delaunay_.site_position(site);
    const Vec2 center = p + reach_ * direction_to(pole_of(row), site);
    return {center, distance(center, p)};
  }
  BallOrigin origin(FamilySlot row) const override {
    return is_far(row) ? BallOrigin::through_sample : BallOrigin::circumdisk;
  }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    if (!is_far(row)) return VoronoiBalls::corners(row);
    const Vec2 p = delaunay_.site_position(site_of(row));
    return {p, p, p};
  }
  void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const override {
    if (!is_far(row)) return VoronoiBalls::touched_samples(row, out);
    out.push_back({site_of(row), delaunay_.site_position(site_of(row))});
  }
  bool has_changed() const override { return !poles_.face_changes().is_empty(); }

 private:
  static constexpr double kReach = 4096.0;
  bool is_beyond_reach(FaceSlot pole) const {
    return pole == kInfinitePole || !(delaunay_.circumradius(pole) <= reach_);
  }
  FamilySlot row_of(SiteSlot site, std::size_t side) const {
    return FamilySlot(delaunay_.face_rows() + side * delaunay_.site_rows() + site.index());
  }
  SiteSlot site_of(FamilySlot row) const {
    return SiteSlot((row.index() - delaunay_.face_rows()) % delaunay_.site_rows());
  }
  FamilySlot ball_of(SiteSlot site, FaceSlot pole, std::size_t side) const {
    if (pole == kNoSlot) return kNoSlot;
    return is_beyond_reach(pole) ? row_of(site, side) : same_row<FamilySlot>(pole);
  }

  const Poles& poles_;
  double reach_ = 1.0;
};

}  // namespace mes

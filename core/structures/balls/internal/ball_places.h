// SPDX-License-Identifier: GPL-3.0-or-later
// What balls of a family and v-points follow, for shapes of explanations.
#pragma once

#include <vector>

#include "core/graph/explain.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {

/// The samples on whose circle a ball is, or none: of balls that are no circumdisks, and where the triangulation is not
/// up to date. Threads: const is safe.
class BallPlaces {
 public:
  BallPlaces(const BallFamily& family, const Explanation& out)
      : family_(family), delaunay_(out.current<Delaunay>()) {}

  FollowedSamples follows(FamilySlot ball) const {
    if (delaunay_ == nullptr || !family_.is_from_samples() || family_.origin(ball) != BallOrigin::circumdisk)
      return {};
    std::vector<TouchedSample> touched;
    family_.touched_samples(ball, touched);
    if (touched.size() < 3) return {};
    FollowedSamples out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = delaunay_->site_sample(touched[i].site);
    return out;
  }
  ShapePlace center(FamilySlot ball) const { return {family_.disk(ball).center, follows(ball)}; }
  void add_circle(ProvenanceShapes& shapes, FamilySlot ball) const {
    shapes.circle(family_.disk(ball), follows(ball));
  }
  /// A v-point that is a sample follows it.
  ShapePlace at(const VPoint& v) const {
    if (delaunay_ == nullptr || v.site == kNoSlot || !delaunay_->is_site(v.site)) return v.position;
    return {v.position, {delaunay_->site_sample(v.site)}};
  }

 private:
  const BallFamily& family_;
  const Delaunay* delaunay_;
};

}  // namespace mes

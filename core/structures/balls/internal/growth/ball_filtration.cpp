// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/growth/ball_filtration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/structures/alpha/persistence.h"

namespace mes {
namespace {

/// The square root of a power, rounded up to the least double or nearly so; negative for a negative power.
double growth_above(double power) {
  const double root = std::sqrt(std::abs(power));
  const bool is_exact = std::fma(root, root, -std::abs(power)) == 0.0;
  if (power >= 0.0) return is_exact ? root : std::nextafter(root, std::numeric_limits<double>::infinity());
  return is_exact ? -root : -std::nextafter(root, 0.0);
}

std::vector<double> growths_of(const std::vector<BallBirths::Level>& levels, const LocalFrame& frame) {
  std::vector<double> out;
  out.reserve(levels.size());
  double most = std::numeric_limits<double>::lowest();
  for (const BallBirths::Level& level : levels) {
    // Nearly flat triangles may enter beyond the range of doubles.
    const double here =
        std::min(frame.to_document_length(growth_above(level.high)), std::numeric_limits<double>::max());
    out.push_back(most = std::max(most, here));
  }
  return out;
}

}  // namespace

BallFiltration::BallFiltration(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                               std::unique_ptr<BallFamily> family, const Parameter& scale)
    : Structure(id, std::move(inputs)), settings_(settings), family_(std::move(family)), scale_(scale) {}

void BallFiltration::find_classes() {
  PlaneFiltration plane;
  plane.corners.reserve(births_.corners.size());
  for (const GrownCornerSlot corner : births_.corners.rows())
    plane.corners.push_back({births_.corners[corner].rank, corner.index()});
  plane.triangles.reserve(births_.triangles.size());
  for (const GrownTriangleSlot triangle : births_.triangles.rows())
    plane.triangles.push_back({births_.triangles[triangle].rank, triangle.index()});
  plane.edges.reserve(births_.edges.size());
  for (const BallBirths::Edge& edge : births_.edges) {
    PlaneFiltration::Edge out{edge.rank, {edge.v[0].index(), edge.v[1].index()}};
    for (std::size_t i = 0; i < 2; ++i)
      if (edge.f[i] != kNoSlot) out.side[i] = edge.f[i].index();
    plane.edges.push_back(out);
  }
  classes_.clear();
  for (const PersistentClass& found : persistent_classes(plane)) {
    Class out{found.is_hole, found.birth, found.death};
    if (found.is_hole) {
      out.edge = GrownEdgeSlot(found.born_with);
      out.triangle = GrownTriangleSlot(found.dies_with);
    } else {
      out.corner = GrownCornerSlot(found.born_with);
      if (found.dies_with != PersistentClass::kNever) out.edge = GrownEdgeSlot(found.dies_with);
    }
    classes_.push_back(out);
  }
}

void BallFiltration::rebuild(JobControl& job) {
  family_->set_scale(settings_.current()[scale_]);
  births_ = {};
  ranks_ = std::make_shared<const GrowthRanks>();
  auto ranks = std::make_shared<GrowthRanks>();
  ranks->balls = local_balls(*family_, job, PointBalls::kept);
  births_ = ball_births(ranks->balls.input(), job);
  ranks->levels = std::move(births_.levels);
  ranks->growth = growths_of(ranks->levels, ranks->balls.frame);
  ranks_ = std::move(ranks);
  find_classes();
}

bool BallFiltration::update(JobControl&) {
  return family_->scale() == settings_.current()[scale_] && !family_->has_changed();
}

StatList BallFiltration::statistics() const {
  std::int64_t joined = 0;
  std::int64_t holes = 0;
  std::int64_t stay = 0;
  for (const Class& one : classes_) ++(one.is_hole ? holes : (one.death == kNever ? stay : joined));
  return {{"balls", static_cast<std::int64_t>(births_.corners.size())},
          {"hidden", static_cast<std::int64_t>(births_.hidden)},
          {"growths", static_cast<std::int64_t>(rank_count())},
          {"joined", joined},
          {"holes", holes},
          {"stay", stay}};
}

ABallFiltration::ABallFiltration(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls)
    : BallFiltration("a-ball-filtration", {&settings, &delaunay, &labels, &balls}, settings,
                     inner_voronoi_balls(delaunay, balls), Parameter::a_scale) {}

BBallFiltration::BBallFiltration(SettingsSource& settings, UserBalls& balls)
    : BallFiltration("b-ball-filtration", {&settings, &balls}, settings, user_ball_family(balls),
                     Parameter::b_scale) {}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/internal/sampled_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/kernel/corner_angle.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/density/feature_size.h"

namespace mes {

MovingCurve curve_of(const SampleData& data, JobControl& job) {
  return data.contours.empty() ? crust_curve(data.positions, job) : known_curve(data.contours, data.positions.size());
}

double turn_at(Vec2 before, Vec2 at, Vec2 after) {
  if (before == at || at == after) return 0.0;
  return before == after ? 180.0 : 180.0 - angle_at(at, before, after);
}

std::vector<bool> corners_of(const MovingCurve& curve, std::span<const Vec2> positions, double epsilon) {
  const double least = 2.0 * std::asin(std::clamp(epsilon, 0.0, 1.0)) * 180.0 / std::numbers::pi;
  constexpr double kMoreThanNeighbours = 4.0;
  std::vector<double> turn(positions.size(), 0.0);
  for_each_moving(curve, [&](std::uint32_t before, std::uint32_t at, std::uint32_t after) {
    turn[at] = turn_at(positions[before], positions[at], positions[after]);
  });
  std::vector<bool> out(positions.size(), false);
  for_each_moving(curve, [&](std::uint32_t before, std::uint32_t at, std::uint32_t after) {
    out[at] = turn[at] > least && turn[at] > kMoreThanNeighbours * (turn[before] + turn[after]);
  });
  return out;
}

JudgedSamples::JudgedSamples(const Registry& registry)
    : bench_(registry, {.keeps_history = false}),
      delaunay_(&bench_.get<Delaunay>()),
      crust_(&bench_.get<OneStepCrust>()),
      sizes_(&bench_.get<FeatureSize>()),
      certificate_(&bench_.get<AxisCertificate>()) {
  bench_.need<FeatureSize, MedialAxis>();
  bench_.set_want_findings(true);
  bench_.set_want_statistics(true);
}

Expected<JudgedSamples> JudgedSamples::of(const Registry& registry, const SampleData& data, JobControl& job,
                                          bool has_curves) {
  JudgedSamples out(registry);
  const std::shared_ptr<const CurveSource> source = has_curves ? data.source : nullptr;
  // Contours say which sides two outlines share.
  if (auto good = out.bench_.load({.positions = data.positions, .contours = data.contours, .source = source}); !good)
    return std::unexpected(good.error());
  out.positions_ = data.positions;
  out.slots_ = out.bench_.document().slots_in_input_order();
  if (auto good = out.bench_.run_or_throw(job); !good) return std::unexpected(good.error());
  return out;
}

Expected<void> JudgedSamples::insert(std::span<const Vec2> positions, JobControl& job) {
  if (auto good = bench_.insert(positions); !good) return std::unexpected(good.error());
  positions_.insert(positions_.end(), positions.begin(), positions.end());
  slots_ = bench_.document().slots_in_input_order();
  bench_.set_want_findings(false);
  return bench_.run_or_throw(job);
}

Expected<void> JudgedSamples::check_theorem(JobControl& job) {
  bench_.set_want_findings(true);
  return bench_.run_or_throw(job);
}

SiteSlot JudgedSamples::site_of(std::uint32_t sample) const {
  return delaunay_->site_of_sample(slots_[sample]);
}

JudgedSamples::EdgeVerdict JudgedSamples::judge(std::uint32_t a, std::uint32_t b) const {
  const SiteSlot from = site_of(a);
  const SiteSlot to = site_of(b);
  EdgeVerdict out;
  if (from == to) {
    out.is_curve = true;
    return out;
  }
  for (const SiteSlot site : {from, to}) {
    out.is_doubted = out.is_doubted || certificate_->is_bad_site(site) || crust_->is_odd(site);
    delaunay_->for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
      out.is_doubted = out.is_doubted || certificate_->is_bad_edge(edge);
      if (site != from || other != to || !crust_->is_crust(edge)) return;
      out.is_curve = true;
      if (sizes_->has_epsilon(edge)) out.epsilon = sizes_->epsilon(edge);
    });
  }
  return out;
}

double JudgedSamples::size(std::uint32_t sample) const {
  const SiteSlot site = site_of(sample);
  return sizes_->has_size(site) ? sizes_->size(site) : std::numeric_limits<double>::infinity();
}

std::int64_t JudgedSamples::count(std::string_view key) const {
  const auto found = bench_.statistic("medial-axis", key);
  return found ? std::get<std::int64_t>(*found) : 0;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/resampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/curves/smooth_curve.h"
#include "core/document/taken_samples.h"
#include "core/evolutions/moving_curve.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/crust/labels.h"
#include "core/structures/density/feature_size.h"

namespace mes {
namespace {

/// Crust, axis and what is proved of samples, from scratch.
class Measured {
 public:
  /// Error: a coordinate out of range.
  static Expected<std::unique_ptr<Measured>> of(std::span<const Vec2> positions, JobControl& job) {
    auto out = std::make_unique<Measured>();
    const auto delta = insert_samples(Document(), positions);
    if (!delta) return std::unexpected(delta.error());
    out->samples_.post(std::make_shared<const DocumentDelta>(*delta));
    out->rebuild(job, {&out->samples_, &out->delaunay_, &out->crust_, &out->sizes_});
    return out;
  }
  /// Needed for what is asked of the certificate.
  void certify(JobControl& job) { rebuild(job, {&labels_, &vertices_, &balls_, &certificate_}); }

  double size_at(std::uint32_t sample) const {
    const SiteSlot site = delaunay_.site_of_sample(SampleSlot(sample));
    return sizes_.has_size(site) ? sizes_.size(site) : std::numeric_limits<double>::infinity();
  }
  bool is_certified() const { return certificate_.has_verdict() && certificate_.is_certified(); }
  /// Where the proof fails: samples, and middles of edges.
  std::vector<Vec2> failures() const {
    std::vector<Vec2> out;
    for (const SiteSlot site : delaunay_.site_slots())
      if (delaunay_.is_site(site) && certificate_.is_bad_site(site)) out.push_back(delaunay_.site_position(site));
    for (const EdgeSlot edge : delaunay_.edge_slots())
      if (delaunay_.edge(edge).is_alive() && certificate_.is_bad_edge(edge)) {
        const auto& [a, b] = delaunay_.edge(edge).v;
        out.push_back(0.5 * (delaunay_.site_position(a) + delaunay_.site_position(b)));
      }
    return out;
  }
  /// Calls `use(epsilon)` for each crust edge that has an epsilon.
  template <class Use>
  void for_each_epsilon(Use use) const {
    for (const EdgeSlot edge : delaunay_.edge_slots())
      if (delaunay_.edge(edge).is_alive() && sizes_.has_epsilon(edge)) use(sizes_.epsilon(edge));
  }

 private:
  static void rebuild(JobControl& job, std::initializer_list<Structure*> structures) {
    for (Structure* structure : structures) {
      job.checkpoint();
      structure->rebuild(job);
    }
  }

  Samples samples_;
  Delaunay delaunay_{samples_};
  OneStepCrust crust_{delaunay_};
  FeatureSize sizes_{delaunay_, crust_};
  Labels labels_{delaunay_, crust_};
  VoronoiVertices vertices_{delaunay_, crust_};
  InnerBalls balls_{delaunay_, vertices_, labels_};
  AxisCertificate certificate_{delaunay_, labels_, balls_};
};

/// What the samples of the data give.
Expected<void> judge(TakenSamples& taken, double wanted, const std::vector<CurveCorner>& corners, JobControl& job) {
  auto measured = Measured::of(taken.data.positions, job);
  if (!measured) return std::unexpected(measured.error());
  (*measured)->certify(job);
  taken.is_certified = (*measured)->is_certified();
  (*measured)->for_each_epsilon([&](double epsilon) {
    if (epsilon <= wanted)
      taken.epsilon = std::max(taken.epsilon, epsilon);
    else
      ++taken.sparse_intervals;
  });
  if (taken.is_certified) return {};
  // A failure belongs to the nearest corner if that is within a few of the spacings that are usual.
  const double reach = [&] {
    Box2 extent;
    for (const Vec2 p : taken.data.positions) extent.add(p);
    constexpr double kShare = 0.02;
    return kShare * length(Vec2{extent.width(), extent.height()});
  }();
  std::vector<bool> is_named(corners.size(), false);
  for (const Vec2 place : (*measured)->failures()) {
    job.checkpoint();
    std::size_t nearest = corners.size();
    double away = reach;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (const double d = distance(corners[i].place, place); d < away) {
        away = d;
        nearest = i;
      }
    if (nearest == corners.size())
      ++taken.other_places;
    else
      is_named[nearest] = true;
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (is_named[i]) taken.corners.push_back(corners[i]);
  return {};
}

/// `asked` stays with the samples as the way in which they were taken.
Expected<TakenSamples> take_once(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                 const SamplingRequest& asked, const FeatureSizes& sizes) {
  auto samples = sample(*curves, request, sizes);
  if (!samples) return std::unexpected(samples.error());
  auto data = taken_from(curves, *std::move(samples), asked);
  if (!data) return std::unexpected(data.error());
  return TakenSamples{.data = *std::move(data)};
}

}  // namespace

Expected<TakenSamples> take_samples(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                    JobControl& job) {
  if (request.rule != SamplingRule::feature_size) return take_once(curves, request, request, {});
  const FeatureSizes sizes = [&job](std::span<const Vec2> positions) -> Expected<std::vector<double>> {
    std::vector<Vec2> places(positions.begin(), positions.end());
    if (std::string fault = bring_into_range(places); !fault.empty())
      return std::unexpected(Error{ErrorCode::bad_input, "of the samples, " + fault});
    auto measured = Measured::of(places, job);
    if (!measured) return std::unexpected(measured.error());
    std::vector<double> out;
    out.reserve(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) out.push_back((*measured)->size_at(i));
    return out;
  };
  const std::vector<CurveCorner> corners =
      request.corner_radius > 0.0 ? std::vector<CurveCorner>() : corners_of(*curves, request.corner_angle);
  // A jitter is what is not on the curve: there is nothing to prove by being denser.
  const int tries = request.jitter > 0.0 ? 1 : 4;
  constexpr double kFiner = 0.63;  // three times make a quarter
  std::optional<TakenSamples> first;
  SamplingRequest finer = request;
  for (int i = 0; i < tries; ++i, finer.epsilon = std::max(kLeastEpsilon, kFiner * finer.epsilon)) {
    auto taken = take_once(curves, finer, request, sizes);
    if (!taken && first) break;  // more samples than there may be
    if (!taken) return taken;
    if (auto done = judge(*taken, finer.epsilon, corners, job); !done) return std::unexpected(done.error());
    if (taken->is_certified) return taken;
    if (!first) first = *std::move(taken);
    // More samples do not help where nothing but corners is in the way.
    if (first->other_places == 0) break;
  }
  return *std::move(first);
}

CurveSet curves_through(const std::vector<Vec2>& positions, JobControl& job) {
  // Where a polygon through samples turns by more, it is taken to have a corner.
  constexpr double kCorner = 0.9;
  const MovingCurve crust = crust_curve(positions, job);
  CurveSet out;
  std::vector<bool> is_on_curve(positions.size(), false);
  std::vector<Vec2> points;
  for (const MovingCurve::Chain& chain : crust.chains) {
    points.clear();
    for (const std::uint32_t i : chain.points) {
      points.push_back(positions[i]);
      is_on_curve[i] = true;
    }
    out.curves.push_back(smooth_curve(points, chain.closed, kCorner));
  }
  for (const auto& [follower, leader] : crust.followers) is_on_curve[follower] = true;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!is_on_curve[i]) out.points.push_back(positions[i]);
  return out;
}

std::string remark_of(const TakenSamples& taken, const SamplingRequest& request) {
  if (request.rule != SamplingRule::feature_size) return {};
  std::string epsilon = taken.epsilon > 0.0 ? fmt::format("epsilon {:.3g}", taken.epsilon) : "no axis";
  if (taken.sparse_intervals != 0)
    epsilon += fmt::format(", but for {} {} at corners and bends", taken.sparse_intervals,
                           taken.sparse_intervals == 1 ? "interval" : "intervals");
  if (taken.is_certified) return epsilon + "; the theorem is proved for these samples";
  if (taken.corners.empty() && taken.other_places == 0) return epsilon + "; there is nothing to prove";
  std::string out = epsilon + "; the theorem is not proved";
  if (!taken.corners.empty()) {
    const auto sharpest = std::ranges::min_element(taken.corners, {}, &CurveCorner::angle);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    out += fmt::format(" at {} {} (the sharpest, {:.3g} degrees, at {:.6g} {:.6g}), where no density is enough",
                       taken.corners.size(), taken.corners.size() == 1 ? "corner" : "corners",
                       kDegrees * sharpest->angle, sharpest->place.x, sharpest->place.y);
  }
  if (taken.other_places != 0)
    out += fmt::format("{} at {} other {}", taken.corners.empty() ? "" : ", and", taken.other_places,
                       taken.other_places == 1 ? "place" : "places");
  return out;
}

}  // namespace mes

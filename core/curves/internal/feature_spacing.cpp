// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/feature_spacing.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "core/curves/internal/bend_spacing.h"

namespace mes {
namespace {

// Rounds that choose all samples again; each changes spacings at most by this factor.
constexpr int kMostRounds = 12;
constexpr double kMostGrowth = 4.0;
// From this round on, spacings only shrink. If the crust is right only for dense samples, they would otherwise become
// sparse again and again.
constexpr int kFirstSteadyRound = 5;
// Rounds that divide intervals.
constexpr int kMostDivisions = 48;
// Between two samples the feature size may be smaller than at both, so the target is denser than required.
constexpr double kMargin = 0.9;
// If at most this share of the intervals is too long, they are divided instead of choosing all samples again.
constexpr double kFew = 0.05;
// If the number of samples would change by more than this factor, another round pays off: either fewer are enough, or
// so many more are needed that dividing intervals (at least by two) would overshoot.
constexpr double kSettled = 0.9;
// Feature sizes are often smaller than radii of curvature, so the first samples are closer by this factor.
constexpr double kDenser = 0.75;
// Intervals beyond this multiple of the finer epsilon are still coarse.
constexpr double kStillCoarse = 1.5;
constexpr double kSpacingRounding = 1e-9;

using Field = std::vector<std::vector<StretchSpacing>>;

/// Evaluates a field at increasing positions along a stretch.
class FieldWalk {
 public:
  explicit FieldWalk(const StretchSpacing& field) : field_(field) {}
  double at(double place) {
    go_to(place);
    const double begin = field_.at[next_ - 1];
    const double end = field_.at[next_];
    if (place <= begin) return field_.spacing[next_ - 1];
    if (place >= end) return field_.spacing[next_];
    const double before = field_.spacing[next_ - 1];
    const double after = field_.spacing[next_];
    if (!std::isfinite(before) || !std::isfinite(after)) return std::min(before, after);
    return before + (place - begin) / (end - begin) * (after - before);
  }
  /// True if the field at `place` exceeds `value`. Positions must not decrease between calls.
  bool is_above(double place, double value) {
    go_to(place);
    if (std::max(field_.spacing[next_ - 1], field_.spacing[next_]) <= value) return false;
    return at(place) > value;
  }

 private:
  void go_to(double place) {
    while (next_ + 1 < field_.at.size() && field_.at[next_] <= place) ++next_;
  }

  const StretchSpacing& field_;
  std::size_t next_ = 1;
};

double count_of(const Field& field) {
  double out = 0.0;
  for (const auto& curve : field)
    for (const StretchSpacing& stretch : curve) out += stretch.count();
  return out;
}

/// The minimum of field and bound, with the nodes of the field and those nodes of the bound that matter.
StretchSpacing bounded_by(const StretchSpacing& field, const StretchSpacing& bound) {
  const std::size_t count = bound.at.size();
  // Nodes where the bound is below the field, and their neighbours.
  std::vector<bool> is_needed(count, false);
  std::size_t needed = 0;
  FieldWalk along_field(field);
  for (std::size_t k = 0; k < count; ++k) {
    if (!along_field.is_above(bound.at[k], bound.spacing[k])) continue;
    for (std::size_t i = k == 0 ? k : k - 1; i < std::min(k + 2, count); ++i) {
      needed += is_needed[i] ? 0U : 1U;
      is_needed[i] = true;
    }
  }
  StretchSpacing out{field.length, {}, {}};
  out.at.reserve(field.at.size() + needed);
  out.spacing.reserve(field.at.size() + needed);
  const auto add = [&out](double at, double spacing) {
    out.at.push_back(at);
    out.spacing.push_back(spacing);
  };
  FieldWalk along_bound(bound);
  FieldWalk again(field);
  std::size_t k = 0;
  for (std::size_t i = 0; i < field.at.size(); ++i) {
    for (; k < count && bound.at[k] < field.at[i]; ++k)
      if (is_needed[k]) add(bound.at[k], std::min(bound.spacing[k], again.at(bound.at[k])));
    while (k < count && bound.at[k] == field.at[i]) ++k;
    add(field.at[i], std::min(field.spacing[i], along_bound.at(field.at[i])));
  }
  return out;
}

/// A feature size changes along a curve by at most the distance, so a bound at one point also bounds nearby points.
/// `steepest` is the growth of the spacing for each unit of length.
void spread_bounds(StretchSpacing& field, double steepest, bool goes_on) {
  std::vector<double>& spacing = field.spacing;
  const auto follow = [&](std::size_t k, std::size_t before) {
    spacing[k] = std::min(spacing[k], spacing[before] + steepest * std::abs(field.at[k] - field.at[before]));
  };
  const int rounds = goes_on ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (round == 1) spacing.front() = spacing.back() = std::min(spacing.front(), spacing.back());
    for (std::size_t k = 1; k < spacing.size(); ++k) follow(k, k - 1);
    for (std::size_t k = spacing.size() - 1; k > 0; --k) follow(k - 1, k);
  }
}

struct StretchSample {
  double at = 0.0;  // arc length along the stretch
  std::uint32_t number = 0;
};

/// Samples of all stretches, each with both its ends, and their measured sizes.
class PlacedSamples {
 public:
  using OfStretch = std::vector<StretchSample>;

  PlacedSamples(std::span<const MeasuredCurve> curves, const Field& field, JobControl* job) : curves_(curves) {
    of_stretch_.resize(curves.size());
    for (std::size_t c = 0; c < curves.size(); ++c)
      for (std::size_t s = 0; s < field[c].size(); ++s) {
        if (job != nullptr) job->checkpoint();
        const Stretch& stretch = curves[c].stretches[s];
        OfStretch& out = of_stretch_[c].emplace_back();
        const std::vector<double> places = field[c][s].places();
        for (const double at : places)
          out.push_back({at, static_cast<std::uint32_t>(positions_.size() + out.size())});
        for_each_place(curves[c], stretch, places, [&](Vec2 p) { positions_.push_back(p); });
        out.push_back({stretch.length, static_cast<std::uint32_t>(positions_.size())});
        positions_.push_back(curves[c].pieces[stretch.first + stretch.count - 1].to());
      }
  }

  Expected<void> measure(const FeatureSizes& sizes) {
    auto found = sizes(positions_);
    if (!found) return std::unexpected(found.error());
    sizes_ = *std::move(found);
    return {};
  }

  std::size_t size() const { return positions_.size(); }
  const std::vector<OfStretch>& of_curve(std::size_t curve) const { return of_stretch_[curve]; }
  Vec2 position(const StretchSample& sample) const { return positions_[sample.number]; }
  double feature_size(const StretchSample& sample) const { return sizes_[sample.number]; }
  /// Half the distance between neighbours, divided by its limit; above 1 it is too long.
  double excess(const StretchSample& a, const StretchSample& b, double epsilon) const {
    const double half = 0.5 * distance(positions_[a.number], positions_[b.number]);
    return half / (epsilon * std::min(sizes_[a.number], sizes_[b.number]));
  }

  /// Adds samples that divide intervals of a stretch evenly by arc length: `parts(a, b)` is the number of parts.
  /// Returns true if it added any.
  template <class Parts>
  bool divide(std::size_t curve, std::size_t stretch, Parts parts) {
    OfStretch& samples = of_stretch_[curve][stretch];
    added_.clear();
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double begin = samples[i - 1].at;
      const int count = parts(samples[i - 1], samples[i]);
      for (int k = 1; k < count; ++k) added_.push_back(begin + (samples[i].at - begin) * k / count);
    }
    if (added_.empty()) return false;
    const std::size_t old = samples.size();
    for (std::size_t i = 0; i < added_.size(); ++i)
      samples.push_back({added_[i], static_cast<std::uint32_t>(positions_.size() + i)});
    for_each_place(curves_[curve], curves_[curve].stretches[stretch], added_,
                   [&](Vec2 p) { positions_.push_back(p); });
    std::ranges::inplace_merge(samples, samples.begin() + static_cast<std::ptrdiff_t>(old), {}, &StretchSample::at);
    return true;
  }

 private:
  std::span<const MeasuredCurve> curves_;
  std::vector<Vec2> positions_;
  std::vector<double> sizes_;
  std::vector<std::vector<OfStretch>> of_stretch_;  // in order along the stretch
  std::vector<double> added_;
};

/// Assessment of the samples of a field.
struct Judged {
  Field next{};  // the spacings that the measured sizes ask for
  std::size_t intervals = 0;
  std::size_t too_long = 0;
  std::size_t coarse = 0;

  static bool are_few(std::size_t some, std::size_t all) {
    return static_cast<double>(some) <= kFew * static_cast<double>(all);
  }
  bool is_near() const { return are_few(too_long, intervals); }
  bool is_fine() const { return are_few(coarse, intervals); }
};

/// True if pieces of the stretch meet at an angle that samples of epsilon `fine` would show as a bend.
bool has_joints(const MeasuredCurve& curve, const Stretch& stretch, double fine) {
  const double least = 2.0 * std::asin(fine);
  for (std::size_t i = stretch.first + 1; i < stretch.first + stretch.count; ++i) {
    const Vec2 before = curve.pieces[i - 1].last_direction();
    const Vec2 after = curve.pieces[i].first_direction();
    if (std::abs(std::atan2(cross(before, after), dot(before, after))) > least) return true;
  }
  return false;
}

class FeatureSampler {
 public:
  FeatureSampler(std::span<const MeasuredCurve> curves, const SpacingLimits& limits, double fine)
      : curves_(curves), limits_(limits), bends_(spacings_by_bends(curves, 2.0 * kMargin * limits.share)) {
    for (const MeasuredCurve& curve : curves) {
      widest_.push_back(std::min(limits.widest, curve.length() / limits.least_each));
      std::vector<double>& here = finer_.emplace_back();
      for (const Stretch& stretch : curve.stretches)
        here.push_back(has_joints(curve, stretch, fine) ? limits.share : fine);
    }
    for (std::size_t c = 0; c < bends_.size(); ++c)
      for (StretchSpacing& stretch : bends_[c])
        for (double& spacing : stretch.spacing) spacing = std::clamp(spacing, finest(c), widest(c));
  }

  /// The finer epsilon of a stretch, or `limits.share` if it has joints.
  double finer(std::size_t curve, std::size_t stretch) const { return finer_[curve][stretch]; }

  /// The initial field, for the finer epsilon. It respects the bounds from bends, at the bends and beside them, so that
  /// the samples show most of the axis at once. Without an axis it would be coarser beside bends.
  Field first(const Field& field) const {
    Field out(field.size());
    for (std::size_t c = 0; c < field.size(); ++c)
      for (std::size_t s = 0; s < field[c].size(); ++s) {
        StretchSpacing bound = bends_[c][s];
        for (double& spacing : bound.spacing) spacing = std::max(kDenser * spacing, finest(c));
        spread_bounds(bound, 2.0 * kMargin * limits_.share, curves_[c].is_closed && !curves_[c].has_corner_at_start);
        StretchSpacing& here = out[c].emplace_back(bounded_by(field[c][s], bound));
        for (double& spacing : here.spacing) spacing = std::max(finer(c, s) / limits_.share * spacing, finest(c));
      }
    return out;
  }

  /// The field, bounded by the bends.
  Field bounded(const Field& field) const {
    Field out(field.size());
    for (std::size_t c = 0; c < field.size(); ++c)
      for (std::size_t s = 0; s < field[c].size(); ++s) out[c].push_back(bounded_by(field[c][s], bends_[c][s]));
    return out;
  }

  Judged judged(const Field& field, const PlacedSamples& samples, bool may_grow) const {
    Judged out{.next = Field(field.size())};
    for (std::size_t c = 0; c < curves_.size(); ++c)
      for (std::size_t s = 0; s < field[c].size(); ++s) judge(c, s, field[c][s], samples, may_grow, out);
    return out;
  }

  /// Number of parts to divide an interval into; 1 if it satisfies the epsilon.
  int parts(std::size_t curve, const PlacedSamples& samples, double epsilon, const StretchSample& a,
            const StretchSample& b) const {
    constexpr double kMost = 4.0;
    const double excess = samples.excess(a, b, epsilon);
    const double along = b.at - a.at;
    if (!(excess > 1.0) || along <= finest(curve) * (1.0 + kSpacingRounding)) return 1;
    return static_cast<int>(std::clamp(std::ceil(std::min(excess, along / finest(curve))), 2.0, kMost));
  }
  /// The radii of curvature at increasing positions of a stretch; each is at least the feature size there.
  std::vector<double> bends_at(std::size_t curve, std::size_t stretch, std::span<const StretchSample> places) const {
    FieldWalk bend(bends_[curve][stretch]);
    std::vector<double> out;
    for (const StretchSample& place : places) out.push_back(bend.at(place.at) / (2.0 * kMargin * limits_.share));
    return out;
  }
  bool may_halve(std::size_t curve, const StretchSample& a, const StretchSample& b) const {
    return b.at - a.at > finest(curve) * (1.0 + kSpacingRounding);
  }

 private:
  double widest(std::size_t curve) const { return widest_[curve]; }
  double finest(std::size_t curve) const { return std::min(limits_.finest, widest(curve)); }

  void judge(std::size_t c, std::size_t s, const StretchSpacing& before, const PlacedSamples& samples, bool may_grow,
             Judged& out) const {
    StretchSpacing& next = out.next[c].emplace_back(StretchSpacing{before.length, {}, {}});
    FieldWalk was(before);
    FieldWalk bend(bends_[c][s]);
    double previous = 0.0;
    const std::vector<StretchSample>& here = samples.of_curve(c)[s];
    next.at.reserve(here.size());
    next.spacing.reserve(here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double now = was.at(here[i].at);
      // Factor for the spacing at both ends of an interval that is too long.
      double shorter = 1.0;
      if (i != 0) {
        ++out.intervals;
        const double excess = samples.excess(here[i - 1], here[i], limits_.share);
        const bool may_be_shorter = may_halve(c, here[i - 1], here[i]);
        if (may_be_shorter && excess * limits_.share > kStillCoarse * finer(c, s)) ++out.coarse;
        if (may_be_shorter && excess > 1.0) {
          ++out.too_long;
          shorter = std::max(kMargin / excess, 1.0 / kMostGrowth);
          next.spacing.back() = std::max(finest(c), std::min(next.spacing.back(), shorter * previous));
        }
      }
      const double most = std::min(may_grow ? kMostGrowth * now : now, bend.at(here[i].at));
      const double wanted = 2.0 * kMargin * limits_.share * samples.feature_size(here[i]);
      double spacing = std::clamp(wanted, std::min(now / kMostGrowth, most), most);
      if (shorter < 1.0) spacing = std::min(spacing, shorter * now);
      next.at.push_back(here[i].at);
      next.spacing.push_back(std::clamp(spacing, finest(c), widest(c)));
      previous = now;
    }
    // A closed curve without corners continues at its beginning.
    if (curves_[c].is_closed && !curves_[c].has_corner_at_start)
      next.spacing.front() = next.spacing.back() = std::min(next.spacing.front(), next.spacing.back());
  }

  std::span<const MeasuredCurve> curves_;
  SpacingLimits limits_;
  std::vector<double> widest_;  // for each curve
  std::vector<std::vector<double>> finer_;
  Field bends_;
};

std::unexpected<Error> too_many(double count, std::size_t most) {
  return std::unexpected(
      Error{ErrorCode::bad_input,
            fmt::format("the curves would have {:.6g} samples; {} are as many as there may be", count, most)});
}

MeasuredPlaces result_of(const PlacedSamples& samples, const FeatureSampler& sampler, std::size_t curves) {
  MeasuredPlaces out(curves);
  for (std::size_t c = 0; c < curves; ++c)
    for (std::size_t s = 0; s < samples.of_curve(c).size(); ++s) {
      const std::vector<StretchSample>& stretch = samples.of_curve(c)[s];
      const std::vector<double> bends = sampler.bends_at(c, s, stretch);
      std::vector<MeasuredPlace>& places = out[c].emplace_back();
      places.reserve(stretch.size());
      for (std::size_t i = 0; i < stretch.size(); ++i) {
        const double size = samples.feature_size(stretch[i]);
        places.push_back({stretch[i].at, samples.position(stretch[i]), std::min(size, bends[i]), 0.0});
        if (i == 0) continue;
        const double epsilon = samples.excess(stretch[i - 1], stretch[i], 1.0);
        for (const std::size_t end : {i - 1, i}) places[end].epsilon = std::max(places[end].epsilon, epsilon);
      }
    }
  return out;
}

}  // namespace

FeatureLimits feature_limits(const SamplingRequest& request, double length, double epsilon) {
  // These samples are measured later, so a coarse first look is enough, refined only moderately.
  constexpr std::size_t kFirstLook = 2000;
  constexpr double kFiner = 8.0;
  const std::size_t count = std::max<std::size_t>(request.count, 1);
  const auto least_each = static_cast<double>(std::max<std::size_t>(request.least_each, 3));
  const double widest = length / static_cast<double>(std::min(count, kFirstLook));
  return {{.widest = widest, .finest = widest / kFiner, .share = request.share, .least_each = least_each},
          {.widest = length,
           .finest = length / static_cast<double>(count) / kFinestFeature,
           .share = epsilon,
           .least_each = least_each}};
}

Expected<MeasuredPlaces> places_by_feature_size(std::span<const MeasuredCurve> curves, Field first,
                                                const SpacingLimits& limits, double fine, std::size_t most,
                                                const FeatureSizes& sizes, JobControl* job) {
  const FeatureSampler sampler(curves, limits, fine);
  Field field = sampler.first(first);
  double count = count_of(field);
  std::optional<PlacedSamples> samples;
  bool is_fine = false;
  for (int round = 0; round < kMostRounds; ++round) {
    if (count > static_cast<double>(most)) return too_many(count, most);
    samples.emplace(curves, field, job);
    if (auto done = samples->measure(sizes); !done) return std::unexpected(done.error());
    const bool may_grow = round < kFirstSteadyRound;
    Judged now = sampler.judged(field, *samples, may_grow);
    is_fine = round == 0 && now.is_near() && now.is_fine();
    if (is_fine) break;
    now.next = sampler.bounded(now.next);  // also bends between two samples
    const double asked = count_of(now.next);
    const bool is_settled = asked > kSettled * count && kSettled * asked < count;
    if (now.is_near() && (!may_grow || is_settled)) break;
    field = std::move(now.next);
    count = asked;
  }

  for (int round = 0; round < kMostDivisions; ++round) {
    bool is_reached = true;
    for (std::size_t c = 0; c < curves.size(); ++c)
      for (std::size_t s = 0; s < samples->of_curve(c).size(); ++s)
        if (samples->divide(c, s, [&](const StretchSample& a, const StretchSample& b) {
              // The first round divides each interval for the finer epsilon; later rounds only enforce the coarser one.
              if (is_fine || round != 0) return sampler.parts(c, *samples, limits.share, a, b);
              const int parts = sampler.parts(c, *samples, sampler.finer(c, s), a, b);
              return sampler.finer(c, s) < limits.share && sampler.may_halve(c, a, b) ? std::max(2, parts) : parts;
            }))
          is_reached = false;
    if (samples->size() > most) return too_many(static_cast<double>(samples->size()), most);
    if (is_reached) break;
    if (auto done = samples->measure(sizes); !done) return std::unexpected(done.error());
  }
  return result_of(*samples, sampler, curves.size());
}

}  // namespace mes

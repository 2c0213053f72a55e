// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/feature_spacing.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace mes {
namespace {

// Rounds until samples are where they should be: each halves or doubles spacings at most a few times.
constexpr int kMostRounds = 24;
// From this round on spacings do not grow any more: where the crust is right only if samples are dense, they would
// become sparse again and again.
constexpr int kFirstSteadyRound = 6;
// Between two samples the feature size may be smaller than at both; what is asked for is denser than what must be had.
constexpr double kMargin = 0.9;
// The most that a spacing changes in a round, as a factor.
constexpr double kMostGrowth = 4.0;
// Fewer samples than that share of what there are would do: worth another round.
constexpr double kSettled = 0.95;

using Field = std::vector<std::vector<StretchSpacing>>;

double interpolated(const StretchSpacing& field, double at) {
  const auto after = std::ranges::upper_bound(field.at, at);
  if (after == field.at.begin()) return field.spacing.front();
  if (after == field.at.end()) return field.spacing.back();
  const auto i = static_cast<std::size_t>(after - field.at.begin());
  const double share = (at - field.at[i - 1]) / (field.at[i] - field.at[i - 1]);
  return field.spacing[i - 1] + share * (field.spacing[i] - field.spacing[i - 1]);
}

double count_of(const Field& field) {
  double out = 0.0;
  for (const auto& curve : field)
    for (const StretchSpacing& stretch : curve) out += stretch.count();
  return out;
}

/// Samples of all stretches, one after the other, each with both its ends.
struct Placed {
  std::vector<Vec2> positions;
  std::vector<double> at;  // of each, along its stretch
};

Placed placed(std::span<const MeasuredCurve> curves, const Field& field) {
  Placed out;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t s = 0; s < field[c].size(); ++s) {
      const Stretch& stretch = curves[c].stretches[s];
      const std::vector<double> places = field[c][s].places();
      for_each_place(curves[c], stretch, places, [&](Vec2 p) { out.positions.push_back(p); });
      out.positions.push_back(curves[c].pieces[stretch.first + stretch.count - 1].to());
      out.at.insert(out.at.end(), places.begin(), places.end());
      out.at.push_back(stretch.length);
    }
  }
  return out;
}

struct Judged {
  Field next;              // what the sizes ask for
  bool is_reached = true;  // by the samples that were measured
};

Judged judged(std::span<const MeasuredCurve> curves, const Field& field, const Placed& samples,
              const std::vector<double>& sizes, const SpacingLimits& limits, bool may_grow) {
  constexpr double kRounding = 1e-9;
  Judged out{.next = Field(field.size())};
  std::size_t i = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const double widest = std::min(limits.widest, curves[c].length() / limits.least_each);
    const double finest = std::min(limits.finest, widest);
    for (const StretchSpacing& before : field[c]) {
      StretchSpacing& next = out.next[c].emplace_back(StretchSpacing{before.length, {}, {}});
      for (bool is_at_end = false; !is_at_end; ++i) {
        const double at = samples.at[i];
        is_at_end = at == before.length;
        // What an interval that is too long must be multiplied by, at both its ends.
        double shorter = 1.0;
        if (!next.at.empty()) {
          const double half = 0.5 * distance(samples.positions[i - 1], samples.positions[i]);
          const double least = limits.share * std::min(sizes[i - 1], sizes[i]);
          if (half > least && at - next.at.back() > finest * (1.0 + kRounding)) {
            out.is_reached = false;
            shorter = std::max(kMargin * least / half, 1.0 / kMostGrowth);
          }
        }
        const double now = interpolated(before, at);
        const double most = may_grow ? kMostGrowth * now : now;
        const double wanted = std::clamp(2.0 * kMargin * limits.share * sizes[i], now / kMostGrowth, most);
        next.at.push_back(at);
        next.spacing.push_back(std::clamp(shorter < 1.0 ? std::min(wanted, shorter * now) : wanted, finest, widest));
        if (shorter < 1.0) {
          double& before_it = next.spacing[next.spacing.size() - 2];
          before_it =
              std::max(finest, std::min(before_it, shorter * interpolated(before, next.at[next.at.size() - 2])));
        }
      }
    }
  }
  return out;
}

}  // namespace

Expected<FeatureSpacings> spacings_by_feature_size(std::span<const MeasuredCurve> curves, Field first,
                                                   const SpacingLimits& limits, std::size_t most,
                                                   const FeatureSizes& sizes) {
  FeatureSpacings out{.spacings = std::move(first)};
  double count = count_of(out.spacings);
  for (int round = 0; round < kMostRounds; ++round) {
    if (count > static_cast<double>(most))
      return std::unexpected(
          Error{ErrorCode::bad_input,
                fmt::format("the curves would have {:.6g} samples; {} are as many as there may be", count, most)});
    const Placed samples = placed(curves, out.spacings);
    const auto found = sizes(samples.positions);
    if (!found) return std::unexpected(found.error());
    Judged now = judged(curves, out.spacings, samples, *found, limits, round < kFirstSteadyRound);
    const double next_count = count_of(now.next);
    out.is_reached = now.is_reached;
    if (now.is_reached && (round >= kFirstSteadyRound || next_count > kSettled * count)) break;
    out.spacings = std::move(now.next);
    count = next_count;
  }
  return out;
}

}  // namespace mes

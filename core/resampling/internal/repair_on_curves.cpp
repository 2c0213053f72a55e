// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/internal/repair_on_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "core/curves/corners.h"
#include "core/curves/feature_field.h"
#include "core/document/taken_samples.h"
#include "core/resampling/internal/sampled_curve.h"
#include "core/structures/density/sample_sizes.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {
namespace {

/// A growing list of samples with its loops.
class GrowingLoops {
 public:
  GrowingLoops(std::vector<Vec2> positions, std::vector<SampleData::Contour> contours)
      : positions_(std::move(positions)), contours_(std::move(contours)) {
    number(0);
  }

  const std::vector<Vec2>& positions() const { return positions_; }
  const std::vector<SampleData::Contour>& contours() const { return contours_; }

  /// Inserts the new samples into the loops. Error: the text of `bring_into_range`.
  std::string insert(const std::vector<FilledInterval>& intervals) {
    std::map<Pair, std::vector<std::uint32_t>> between;  // ordered from the first of the pair
    const std::size_t first = positions_.size();
    for (const FilledInterval& interval : intervals) {
      const std::uint32_t from = first_at_[interval.from];
      const std::uint32_t to = first_at_[interval.to];
      const auto [at, is_new] = between.try_emplace(std::minmax(from, to));
      if (!is_new) continue;  // curves that share this part
      for (const Vec2 p : interval.positions) {
        at->second.push_back(static_cast<std::uint32_t>(positions_.size()));
        positions_.push_back(p);
      }
      if (from > to) std::ranges::reverse(at->second);
    }
    if (std::string fault = bring_into_range(positions_); !fault.empty()) return fault;
    number(first);
    for (SampleData::Contour& contour : contours_) {
      std::vector<std::uint32_t> points;
      const std::size_t count = contour.points.size();
      for (std::size_t i = 0; i < count; ++i) {
        points.push_back(contour.points[i]);
        if (i + 1 == count && !contour.closed) continue;
        const std::uint32_t from = first_at_[contour.points[i]];
        const std::uint32_t to = first_at_[contour.points[(i + 1) % count]];
        const auto found = between.find(std::minmax(from, to));
        if (found == between.end() || (count == 2 && i == 1)) continue;
        if (from < to)
          points.insert(points.end(), found->second.begin(), found->second.end());
        else
          points.insert(points.end(), found->second.rbegin(), found->second.rend());
      }
      contour.points = std::move(points);
    }
    return {};
  }

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  void number(std::size_t first) {
    for (std::size_t i = first; i < positions_.size(); ++i) {
      const auto own = static_cast<std::uint32_t>(i);
      first_at_.push_back(at_place_.try_emplace({positions_[i].x, positions_[i].y}, own).first->second);
    }
  }

  std::vector<Vec2> positions_;
  std::vector<SampleData::Contour> contours_;
  std::vector<std::uint32_t> first_at_;  // by sample: the first sample at the same position
  std::map<std::pair<double, double>, std::uint32_t> at_place_;
};

/// The samples after one step of insertion, and their standing.
struct Step {
  std::vector<Vec2> positions;
  std::vector<SampleData::Contour> contours;
  CurveStanding standing;
  SamplingVerdict verdict;
};

}  // namespace

Expected<std::optional<Repair>> repair_on_curves(const Registry& registry, const SampleData& data, double epsilon,
                                                 JobControl& job) {
  if (!data.source) return std::nullopt;
  auto samples = JudgedSamples::of(registry, data, job, true);
  if (!samples) return std::unexpected(samples.error());
  SamplingRequest request = data.source->sampling;
  if (request.count == 0) request.count = kUsualSamples;
  // The feature field is needed even where the theorem light gives up on too many curves.
  std::optional<FeatureField> own;
  if (samples->curves().field() != nullptr) {
    own = *samples->curves().field();
  } else {
    SampleSizes sizes(job);
    auto field = FeatureField::of(
        *data.source->curves, request, [&sizes](std::span<const Vec2> positions) { return sizes.of(positions); },
        &job);
    if (!field) return std::unexpected(field.error());
    own = *std::move(field);
  }
  const CurveStanding before = own->standing(data.positions, &job);
  if (2 * before.off_curve > data.positions.size()) return std::nullopt;

  std::optional<Repair> out(std::in_place);
  out->before = samples->verdict();
  out->off_curve = before.off_curve;
  out->is_on_curves = true;
  if (!own->has_axis()) out->no_axis = "the curves have no axis";
  out->crossings = faults_of_outlines(data.source->curves->curves, job).crossings;
  if (out->crossings != 0) {
    out->data = data;
    out->after = out->before;
    return out;
  }
  // First only edges away from corners; if the theorem asks for more, then ever nearer to the corners, and denser.
  struct Try {
    double epsilon;
    bool is_strict;
  };
  const std::array<Try, 4> tries{{{epsilon, false}, {epsilon, true}, {0.6 * epsilon, true}, {0.4 * epsilon, true}}};
  GrowingLoops loops(data.positions, data.contours);
  std::optional<Step> best;
  for (const Try& now : tries) {
    job.checkpoint();
    const std::size_t count = loops.positions().size();
    if (std::string fault = loops.insert(own->filled(loops.positions(), now.epsilon, now.is_strict, &job));
        !fault.empty())
      return std::unexpected(Error{ErrorCode::bad_input, "of the samples, " + fault});
    if (loops.positions().size() != count)
      if (auto done = samples->insert(std::span(loops.positions()).subspan(count), job); !done)
        return std::unexpected(done.error());
    if (auto done = samples->check_theorem(job); !done) return std::unexpected(done.error());
    Step step{loops.positions(), loops.contours(), own->standing(loops.positions(), &job), samples->verdict()};
    const bool is_good = step.verdict.light != TheoremLight::yellow;
    if (is_good || !best) best = std::move(step);
    if (is_good) break;
  }
  out->data = data;
  out->inserted = best->positions.size() - data.positions.size();
  out->data.positions = std::move(best->positions);
  out->data.contours = std::move(best->contours);
  const CurveSource& source = *data.source;
  if (std::size_t{source.first} + source.count == data.positions.size()) {
    CurveSource longer = source;
    longer.count += static_cast<std::uint32_t>(out->inserted);
    out->data.source = std::make_shared<const CurveSource>(std::move(longer));
  }
  out->after = std::move(best->verdict);
  if (request.corner_radius == 0.0)
    for (const CurveCorner& corner : corners_of(*source.curves, request.corner_angle))
      out->corners.push_back({corner.place, corner.angle * 180.0 / std::numbers::pi});
  if (best->standing.epsilon > epsilon) out->left.push_back(best->standing.place);
  return out;
}

}  // namespace mes

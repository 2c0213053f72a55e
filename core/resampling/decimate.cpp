// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/decimate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/base/counted.h"
#include "core/graph/explain.h"
#include "core/resampling/internal/before_and_now.h"
#include "core/resampling/internal/sampled_curve.h"

namespace mes {
namespace {

/// The fewest samples that a thinned loop keeps.
constexpr std::size_t kFewestOfLoop = 4;

/// A chain with some of its samples left out.
class ThinnedChain {
 public:
  ThinnedChain(const MovingCurve::Chain& chain, std::vector<bool> must_stay)
      : chain_(&chain), must_stay_(std::move(must_stay)), is_kept_(chain.points.size(), true) {}

  std::size_t size() const { return chain_->points.size(); }
  std::uint32_t sample(std::size_t i) const { return chain_->points[i % size()]; }
  bool is_kept(std::size_t i) const { return is_kept_[i % size()]; }
  void keep(std::size_t i) { is_kept_[i % size()] = true; }

  /// Walks from each kept sample to the farthest next one that half the distance allows, and drops those between.
  void thin(std::span<const Vec2> positions, const std::vector<double>& sizes, double epsilon) {
    const std::size_t n = size();
    if (n <= kFewestOfLoop) return;
    const std::size_t first = start(sizes);
    const std::size_t end = chain_->closed ? first + n : n - 1;
    for (std::size_t from = first; from < end;) {
      std::size_t to = from + 1;
      double least = std::min(sizes[sample(from)], sizes[sample(to)]);
      for (; to < end && !must_stay_[to % n]; ++to) {
        least = std::min(least, sizes[sample(to + 1)]);
        if (!(0.5 * distance(positions[sample(from)], positions[sample(to + 1)]) <= epsilon * least)) break;
      }
      for (std::size_t i = from + 1; i < to; ++i) is_kept_[i % n] = false;
      from = to;
    }
    if (!chain_->closed || static_cast<std::size_t>(std::ranges::count(is_kept_, true)) >= kFewestOfLoop) return;
    for (std::size_t i = 0; i < kFewestOfLoop; ++i) keep(first + i * n / kFewestOfLoop);
  }

  /// Calls `visit(i, j)` for each two successive kept indices; j may lie beyond the end of a loop.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    const auto begin = static_cast<std::size_t>(std::ranges::find(is_kept_, true) - is_kept_.begin());
    const std::size_t end = chain_->closed && size() > 2 ? begin + size() : size() - 1;
    for (std::size_t i = begin; i < end;) {
      std::size_t j = i + 1;
      while (j < end && !is_kept(j)) ++j;
      visit(i, j);
      i = j;
    }
  }

 private:
  /// Start index in a loop: a sample that must stay, or else the one with the smallest feature size.
  std::size_t start(const std::vector<double>& sizes) const {
    if (!chain_->closed) return 0;
    const auto stays = std::ranges::find(must_stay_, true);
    if (stays != must_stay_.end()) return static_cast<std::size_t>(stays - must_stay_.begin());
    std::size_t out = 0;
    for (std::size_t i = 1; i < size(); ++i)
      if (sizes[sample(i)] < sizes[sample(out)]) out = i;
    return out;
  }

  const MovingCurve::Chain* chain_;
  std::vector<bool> must_stay_;
  std::vector<bool> is_kept_;
};

SampleData without(const SampleData& data, const std::vector<bool>& is_gone, std::vector<std::uint32_t>& number) {
  SampleData out;
  number.assign(data.positions.size(), 0);
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    if (is_gone[i]) continue;
    number[i] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(data.positions[i]);
  }
  for (const SampleData::Contour& contour : data.contours) {
    SampleData::Contour& rest = out.contours.emplace_back();
    rest.closed = contour.closed;
    for (const std::uint32_t sample : contour.points)
      if (!is_gone[sample]) rest.points.push_back(number[sample]);
  }
  out.balls = data.balls;
  return out;
}

/// The samples after thinning, and the verdict on them.
struct Thinned {
  SampleData data;
  SamplingVerdict verdict;
  bool has_same_axis = false;
  std::vector<std::pair<std::size_t, std::size_t>> wanted_back;  // chain, and index on it
  std::vector<std::pair<std::size_t, std::size_t>> thinned;      // one index of each edge that skips samples
};

class Decimator {
 public:
  /// `field`, unless null: of the curves on which all samples lie.
  Decimator(const Registry& registry, const SampleData& data, const MovingCurve& curve, const JudgedSamples& before,
            const FeatureField* field, double epsilon)
      : registry_(registry),
        data_(data),
        field_(field),
        epsilon_(epsilon),
        light_(before.light()),
        components_(before.components()),
        cycles_(before.cycles()) {
    const std::vector<bool> is_corner = corners_of(curve, data.positions, epsilon);
    std::vector<bool> may_go = curve.may_move;
    for (std::size_t i = 0; i < may_go.size(); ++i) may_go[i] = may_go[i] && !is_corner[i];
    // The structures merge samples at equal positions into one.
    for (const auto& [follower, leader] : curve.followers) may_go[follower] = may_go[leader] = false;
    for (const MovingCurve::Chain& chain : curve.chains) {
      if (chain.points.size() < 2) continue;
      std::vector<bool> must_stay;
      must_stay.reserve(chain.points.size());
      for (const std::uint32_t sample : chain.points) must_stay.push_back(!may_go[sample]);
      chains_.emplace_back(chain, std::move(must_stay));
    }
    std::vector<double> sizes(data.positions.size());
    for (std::uint32_t i = 0; i < sizes.size(); ++i) sizes[i] = before.size(i);
    for (ThinnedChain& chain : chains_) chain.thin(data.positions, sizes, epsilon);
  }

  std::vector<bool> gone() const {
    std::vector<bool> out(data_.positions.size(), false);
    for (const ThinnedChain& chain : chains_)
      for (std::size_t i = 0; i < chain.size(); ++i)
        if (!chain.is_kept(i)) out[chain.sample(i)] = true;
    return out;
  }
  void take_back(const std::vector<std::pair<std::size_t, std::size_t>>& places) {
    for (const auto& [chain, i] : places) chains_[chain].keep(i);
  }

  Expected<Thinned> judge(JobControl& job) const {
    Thinned out;
    std::vector<std::uint32_t> number;
    out.data = without(data_, gone(), number);
    const auto now = JudgedSamples::of(registry_, out.data, job);
    if (!now) return std::unexpected(now.error());
    out.verdict = now->verdict();
    const std::set<std::pair<std::uint32_t, std::uint32_t>> sparse = sparse_intervals(out.data.positions, job);
    out.has_same_axis = now->components() == components_ && now->cycles() == cycles_ &&
                        out.verdict.light <= std::max(light_, TheoremLight::green);
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const ThinnedChain& chain = chains_[c];
      chain.for_each_edge([&](std::size_t i, std::size_t j) {
        if (j == i + 1) return;
        const auto verdict = now->judge(number[chain.sample(i)], number[chain.sample(j)]);
        out.thinned.emplace_back(c, (i + j) / 2);
        const bool is_sparse = sparse.contains(std::minmax({number[chain.sample(i)], number[chain.sample(j)]}));
        if (!verdict.is_curve || verdict.epsilon > epsilon_ || is_sparse)
          out.wanted_back.emplace_back(c, (i + j) / 2);
      });
    }
    return out;
  }

 private:
  /// Samples between which the curves need others, the smaller number first.
  std::set<std::pair<std::uint32_t, std::uint32_t>> sparse_intervals(std::span<const Vec2> positions,
                                                                     JobControl& job) const {
    std::set<std::pair<std::uint32_t, std::uint32_t>> out;
    if (field_ == nullptr) return out;
    for (const FilledInterval& interval : field_->filled(positions, epsilon_, false, &job))
      out.insert(std::minmax({interval.from, interval.to}));
    return out;
  }

  const Registry& registry_;
  const SampleData& data_;
  const FeatureField* field_;
  double epsilon_;
  TheoremLight light_;
  std::int64_t components_;
  std::int64_t cycles_;
  std::vector<ThinnedChain> chains_;
};

/// Samples at the positions, all of the curves of the data.
Expected<JudgedSamples> judged_on_curves(const Registry& registry, const SampleData& data,
                                         const std::vector<Vec2>& positions, JobControl& job) {
  CurveSource source = *data.source;
  source.first = 0;
  source.count = static_cast<std::uint32_t>(positions.size());
  return JudgedSamples::of(registry,
                           {.positions = positions, .source = std::make_shared<const CurveSource>(std::move(source))},
                           job, true);
}

}  // namespace

Expected<Decimation> decimate(const Registry& registry, const SampleData& data, double epsilon, JobControl& job) {
  const auto before = JudgedSamples::of(registry, data, job);
  if (!before) return std::unexpected(before.error());
  const MovingCurve curve = curve_of(data, job);
  Decimation out;
  out.before = before->verdict();
  std::optional<JudgedSamples> on_curves;
  const FeatureField* field = nullptr;
  if (data.source) {
    auto judged = judged_on_curves(registry, data, data.positions, job);
    if (!judged) return std::unexpected(judged.error());
    on_curves = *std::move(judged);
    out.before = on_curves->verdict();
    const CurveSampling& curves = on_curves->curves();
    if (curves.has_standing() && curves.standing().off_curve == 0) field = curves.field();
  }
  Decimator decimator(registry, data, curve, *before, field, epsilon);
  // An edge that is not a curve edge, or is too long now, gets its middle sample back; if the axis has changed, all
  // such edges do. In the worst case the loop ends with all samples back.
  for (;;) {
    job.checkpoint();
    auto now = decimator.judge(job);
    if (!now) return std::unexpected(now.error());
    const auto& back = now->wanted_back.empty() && !now->has_same_axis ? now->thinned : now->wanted_back;
    if (!back.empty()) {
      decimator.take_back(back);
      continue;
    }
    const std::vector<bool> is_gone = decimator.gone();
    for (std::uint32_t i = 0; i < is_gone.size(); ++i)
      if (is_gone[i]) out.removed.push_back(i);
    out.data = std::move(now->data);
    out.after = std::move(now->verdict);
    out.no_axis = before->why_no_axis();
    out.components = before->components();
    out.cycles = before->cycles();
    // The verdict needs the distances of the samples to their curves, which are not measured while samples are tried.
    if (data.source) {
      const auto judged = judged_on_curves(registry, data, out.data.positions, job);
      if (!judged) return std::unexpected(judged.error());
      out.after = judged->verdict();
    }
    return out;
  }
}

std::string Decimation::words() const {
  const std::string went = counted(removed.size(), "sample", "samples") + " of " +
                           grouped(removed.size() + data.positions.size()) + " removed; ";
  if (!no_axis.empty()) return went + no_axis;
  return went + "the axis has " + counted(static_cast<std::size_t>(components), "component", "components") + " and " +
         counted(static_cast<std::size_t>(cycles), "cycle", "cycles") + " as before; " +
         before_and_now(before, after);
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/sampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/curves/corners.h"
#include "core/curves/feature_field.h"
#include "core/curves/internal/network.h"
#include "core/curves/internal/repeated_positions.h"
#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"
#include "core/curves/jitter.h"

namespace mes {
namespace {

// Largest density of the adaptive rule, relative to even samples.
constexpr double kFiner = 8.0;
// Rules that search the surroundings take some hundred bytes for each sample.
constexpr std::size_t kMostUneven = 1'000'000;
// Curves with more pieces are sampled evenly when they are opened, in linear time.
constexpr std::size_t kMostAdaptivePieces = 20'000;

std::unexpected<Error> refused(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text)});
}

std::unexpected<Error> beyond_range() {
  return refused(ErrorCode::bad_input, "the curves reach beyond the range of numbers");
}

std::unexpected<Error> too_many_for_rule() {
  return refused(ErrorCode::bad_input, fmt::format("by this rule there may be no more than {} samples", kMostUneven));
}

/// The data that determines the number of samples of a curve.
struct Outline {
  std::vector<double> stretches;  // lengths
  double length = 0.0;
  double whole = 0.0;  // length of the curve that it is a part of; 0: not a part
  bool is_closed = false;
  bool is_straight = false;
};

Outline outline_of(const MeasuredCurve& curve) {
  Outline out;
  for (const Stretch& stretch : curve.stretches) out.stretches.push_back(stretch.length);
  out.length = curve.length();
  out.whole = curve.whole;
  out.is_closed = curve.is_closed;
  out.is_straight = curve.stretches.size() == 1 && std::ranges::all_of(curve.pieces, [](const Piece& piece) {
                      return piece.kind == PieceKind::line;
                    });
  return out;
}

constexpr double kIntervalRounding = 1e-9;

/// Number of intervals of a stretch at a spacing. A multiple of the spacing is recognized up to rounding.
double intervals_of(double length, double spacing) {
  return std::max(1.0, std::ceil(length / spacing * (1.0 - kIntervalRounding)));
}

double spacing_for(const Outline& curve, double spacing, std::size_t least_each) {
  const bool is_bounded = curve.is_closed || !curve.is_straight || curve.whole > 0.0;
  if (!is_bounded || curve.stretches.empty()) return spacing;
  return std::min(spacing, (curve.whole > 0.0 ? curve.whole : curve.length) /
                               static_cast<double>(std::max<std::size_t>(least_each, 3)));
}

double sample_count(const Outline& curve, double spacing, std::size_t least_each) {
  if (curve.stretches.empty()) return 1.0;
  const double here = spacing_for(curve, spacing, least_each);
  double sum = curve.is_closed ? 0.0 : 1.0;
  for (const double length : curve.stretches) sum += intervals_of(length, here);
  return sum;
}

double sample_count(const std::vector<Outline>& curves, double spacing, std::size_t least_each) {
  double sum = 0.0;
  for (const Outline& curve : curves) sum += sample_count(curve, spacing, least_each);
  return sum;
}

/// The least spacing, up to rounding, that gives at most `count` samples; the total length if none does.
double spacing_for_count(const std::vector<Outline>& curves, std::size_t count, std::size_t least_each) {
  double all = 0.0;
  for (const Outline& curve : curves) all += curve.length;
  if (all == 0.0) return 1.0;
  const auto wanted = static_cast<double>(std::max<std::size_t>(count, 1));
  double low = 0.5 * all / wanted;  // gives too many
  double high = all;                // gives the fewest possible
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps; ++step) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (sample_count(curves, middle, least_each) > wanted ? low : high) = middle;
  }
  // Keep lengths that are equal up to rounding on the same side.
  return high * (1.0 + 2.0 * kIntervalRounding);
}

/// The curves to sample, or the arcs of their network.
struct Sources {
  const CurveSet& curves;
  const CurveNetwork* network = nullptr;

  MeasuredCurve measured(std::size_t i, const SamplingRequest& request, double negligible, JobControl* job) const {
    const bool keeps_vertices = request.rule == SamplingRule::refined;
    const bool has_node = network != nullptr && network->nodes[i][0] != CurveNetwork::kNoNode;
    MeasuredCurve out = mes::measured(curves.curves[i], keeps_vertices ? -1.0 : request.corner_angle,
                                      keeps_vertices ? 0.0 : negligible, job, has_node);
    if (network == nullptr) return out;
    out.nodes = network->nodes[i];
    out.whole = network->whole[i];
    return out;
  }
};

/// Collects samples, and removes repeated ones of the current curve.
class Collector {
 public:
  /// If `keeps_all`, curves that are single points get a chain as well.
  explicit Collector(JobControl* job, bool keeps_all) : job_(job), keeps_all_(keeps_all) {}
  /// Throws `Cancelled`.
  void checkpoint() const {
    if (job_ != nullptr) job_->checkpoint();
  }
  JobControl* job() const { return job_; }
  void begin_curve(bool is_closed) { out_.chains.push_back({is_closed, out_.positions.size(), 0}); }
  void add(Vec2 position) {
    constexpr std::size_t kOften = 4096;
    if (out_.positions.size() % kOften == 0) checkpoint();
    out_.positions.push_back(position);
  }
  void add(std::span<const Vec2> positions) {
    constexpr std::size_t kOften = 4096;
    for (; !positions.empty(); positions = positions.subspan(std::min(positions.size(), kOften))) {
      checkpoint();
      const auto part = positions.first(std::min(positions.size(), kOften));
      out_.positions.insert(out_.positions.end(), part.begin(), part.end());
    }
  }
  /// Replaces all samples.
  void take(SampledCurves samples) { out_ = std::move(samples); }
  void reserve(std::size_t count) { out_.positions.reserve(count); }

  void end_curve() {
    SampledCurves::Chain& chain = out_.chains.back();
    remove_repetitions(chain.first);
    chain.count = out_.positions.size() - chain.first;
    if (chain.count < 2 && !keeps_all_) {
      out_.chains.pop_back();
    } else if (chain.count < 3) {
      chain.is_closed = false;
    }
  }

  /// Whether the samples of all finished curves are finite.
  bool are_finite() const { return repeated_.were_finite(); }
  SampledCurves result() && { return std::move(out_); }

 private:
  void remove_repetitions(std::size_t first) {
    const auto repeated = repeated_.find(std::span(out_.positions).subspan(first));
    if (repeated.empty()) return;
    const auto begin = out_.positions.begin() + static_cast<std::ptrdiff_t>(first);
    auto to = begin + repeated.front();
    for (std::size_t k = 0; k < repeated.size(); ++k)
      to = std::copy(begin + repeated[k] + 1,
                     k + 1 < repeated.size() ? begin + repeated[k + 1] : out_.positions.end(), to);
    out_.positions.erase(to, out_.positions.end());
  }

  JobControl* job_;
  bool keeps_all_;
  SampledCurves out_;
  RepeatedPositions repeated_;
};

void add_vertices(const PlaneCurve& curve, Collector& out) {
  out.begin_curve(curve.is_closed());
  if (curve.is_polyline()) {
    out.add(curve.points());
    return out.end_curve();
  }
  out.add(curve.start());
  // Two vertices enclose nothing, so a circle of two arcs also has the middles of its arcs.
  const std::size_t pieces = curve.piece_count();
  const std::size_t parts = curve.is_closed() && pieces < 3 ? 4 - pieces : 1;
  // The last sample of a closed curve repeats its start and is removed again.
  curve.for_each_piece([&](const Piece& piece) {
    for (std::size_t i = 1; i < parts; ++i) out.add(piece.at(static_cast<double>(i) / static_cast<double>(parts)));
    out.add(piece.to());
  });
  out.end_curve();
}

/// Adds samples at arc lengths from the beginning of a stretch, in order; also at its end if `adds_end`.
void add_places(const MeasuredCurve& curve, const Stretch& stretch, const std::vector<double>& places, bool adds_end,
                Collector& out) {
  for_each_place(curve, stretch, places, [&](Vec2 p) { out.add(p); });
  if (adds_end) out.add(curve.pieces[stretch.first + stretch.count - 1].to());
}

std::vector<double> even_places(double length, double intervals) {
  std::vector<double> out;
  for (double i = 0.0; i < intervals; ++i) out.push_back(length * (i / intervals));
  return out;
}

void add_evenly(const MeasuredCurve& curve, const PlaneCurve& source, double spacing, const SamplingRequest& request,
                Collector& out) {
  out.begin_curve(curve.is_closed);
  if (curve.stretches.empty()) out.add(source.start());
  const double here = spacing_for(outline_of(curve), spacing, request.least_each);
  for (std::size_t i = 0; i < curve.stretches.size(); ++i) {
    const Stretch& stretch = curve.stretches[i];
    const bool adds_end = !curve.is_closed && i + 1 == curve.stretches.size();
    add_places(curve, stretch, even_places(stretch.length, intervals_of(stretch.length, here)), adds_end, out);
  }
  out.end_curve();
}

/// Adds a curve from the samples in its stretches.
void add_stretches(const MeasuredCurve& curve, const PlaneCurve& source,
                   const std::vector<std::vector<Vec2>>& positions, Collector& out) {
  out.begin_curve(curve.is_closed);
  if (curve.stretches.empty()) out.add(source.start());
  for (const std::vector<Vec2>& stretch : positions) out.add(stretch);
  if (!curve.is_closed && !curve.stretches.empty()) {
    const Stretch& last = curve.stretches.back();
    out.add(curve.pieces[last.first + last.count - 1].to());
  }
  out.end_curve();
}

double widest_for(double length, std::size_t count) {
  return length / static_cast<double>(std::max<std::size_t>(count, 1));
}

Expected<void> check_count(double count, const SamplingRequest& request) {
  if (count <= static_cast<double>(request.most)) return {};
  const std::string many = std::isfinite(count) ? fmt::format("{:.6g}", count) : "far too many";
  return refused(ErrorCode::bad_input,
                 fmt::format("the curves would have {} samples; {} are as many as there may be", many, request.most));
}

/// The vertices of many polylines, on several threads. Returns nothing if a vertex is repeated or not finite.
std::optional<SampledCurves> vertices_that_differ(const CurveSet& curves, JobControl* job) {
  constexpr std::size_t kVerticesEach = std::size_t{1} << 15U;
  SampledCurves out;
  out.chains.reserve(curves.curves.size());
  std::vector<std::size_t> ends;  // ends of runs of curves, each a similar amount of work
  std::size_t count = 0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < curves.curves.size(); ++i) {
    const PlaneCurve& curve = curves.curves[i];
    constexpr std::size_t kTriangle = 3;
    if (!curve.is_polyline() || curve.piece_count() < kTriangle) return std::nullopt;
    // A closed curve ends where it starts.
    const std::size_t vertices = curve.is_closed() ? curve.piece_count() : curve.piece_count() + 1;
    out.chains.push_back({curve.is_closed(), count, vertices});
    count += vertices;
    if (count - counted < kVerticesEach && i + 1 < curves.curves.size()) continue;
    ends.push_back(i + 1);
    counted = count;
  }
  // Copied in order: threads could only fill existing elements, which would first be set to zero.
  out.positions.reserve(count);
  constexpr std::size_t kOften = 4096;
  for (std::size_t i = 0; i < out.chains.size(); ++i) {
    const std::span from = std::span(curves.curves[i].points()).first(out.chains[i].count);
    for (std::size_t k = 0; k < from.size(); k += kOften) {
      if (job != nullptr && job->stop_requested()) throw Cancelled{};
      const auto part = from.subspan(k, std::min(kOften, from.size() - k));
      out.positions.insert(out.positions.end(), part.begin(), part.end());
    }
  }
  std::atomic<bool> is_good = true;
  run_tasks(ends.size(), [&](std::size_t run) {
    RepeatedPositions repeated;
    for (std::size_t i = run == 0 ? 0 : ends[run - 1]; i < ends[run] && is_good; ++i) {
      if (job != nullptr && job->stop_requested()) throw Cancelled{};
      const SampledCurves::Chain& chain = out.chains[i];
      const std::span here = std::span(out.positions).subspan(chain.first, chain.count);
      if (!repeated.find(here).empty() || !repeated.were_finite()) is_good = false;
    }
  });
  return is_good ? std::optional(std::move(out)) : std::nullopt;
}

Expected<void> sample_vertices(const CurveSet& curves, const SamplingRequest& request, Collector& out) {
  double count = 0.0;
  for (const PlaneCurve& curve : curves.curves)
    count += static_cast<double>(curve.piece_count()) + (curve.is_closed() ? 0.0 : 1.0);
  if (auto fits = check_count(count, request); !fits) return fits;
  if (auto all = vertices_that_differ(curves, out.job())) {
    out.take(*std::move(all));
    return {};
  }
  out.reserve(static_cast<std::size_t>(count) + curves.curves.size() + curves.points.size());
  for (const PlaneCurve& curve : curves.curves) add_vertices(curve, out);
  return {};
}

Expected<void> sample_evenly(const Sources& sources, const SamplingRequest& request, Collector& out) {
  const std::vector<PlaneCurve>& curves = sources.curves.curves;
  std::vector<Outline> outlines;
  outlines.reserve(curves.size());
  const double negligible = negligible_length(sources.curves, request);
  double all = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    outlines.push_back(outline_of(sources.measured(i, request, negligible, out.job())));
    all += outlines.back().length;
    if (!std::isfinite(all)) return beyond_range();
  }
  double spacing = request.spacing;
  if (request.rule == SamplingRule::count) spacing = spacing_for_count(outlines, request.count, request.least_each);
  if (request.rule == SamplingRule::refined) spacing = all > 0.0 ? widest_for(all, request.count) : 1.0;
  if (auto fits = check_count(sample_count(outlines, spacing, request.least_each), request); !fits) return fits;
  for (std::size_t i = 0; i < curves.size(); ++i)
    add_evenly(sources.measured(i, request, negligible, out.job()), curves[i], spacing, request, out);
  return {};
}

/// Samples for each curve and each of its stretches, without the ends.
using Positions = std::vector<std::vector<std::vector<Vec2>>>;

Expected<Positions> positions_by(const std::vector<std::vector<StretchSpacing>>& spacings,
                                 std::span<const MeasuredCurve> curves, const SamplingRequest& request,
                                 JobControl* job) {
  double count = 0.0;
  for (const std::vector<StretchSpacing>& curve : spacings)
    for (const StretchSpacing& stretch : curve) count += stretch.count();
  if (auto fits = check_count(count, request); !fits) return std::unexpected(fits.error());
  constexpr std::size_t kOften = 4096;
  Positions out(spacings.size());
  for (std::size_t c = 0; c < spacings.size(); ++c)
    for (std::size_t s = 0; s < spacings[c].size(); ++s) {
      std::vector<Vec2>& here = out[c].emplace_back();
      const std::vector<double> places = spacings[c][s].places();
      here.reserve(places.size());
      for_each_place(curves[c], curves[c].stretches[s], places, [&](Vec2 p) {
        if (job != nullptr && here.size() % kOften == 0) job->checkpoint();
        here.push_back(p);
      });
    }
  return out;
}

Expected<Positions> positions_at(const std::vector<std::vector<std::vector<double>>>& places,
                                 std::span<const MeasuredCurve> curves, JobControl* job) {
  constexpr std::size_t kOften = 4096;
  Positions out(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (std::size_t s = 0; s < places[c].size(); ++s) {
      std::vector<Vec2>& here = out[c].emplace_back();
      here.reserve(places[c][s].size());
      for_each_place(curves[c], curves[c].stretches[s], places[c][s], [&](Vec2 p) {
        if (job != nullptr && here.size() % kOften == 0) job->checkpoint();
        here.push_back(p);
      });
    }
  return out;
}

/// Samples by the rules with varying spacing. `field` is needed for the rule `feature_size`.
Expected<Positions> uneven_positions(std::span<const MeasuredCurve> curves, double length,
                                     const SamplingRequest& request, const FeatureField* field, JobControl* job) {
  if (request.rule == SamplingRule::feature_size) {
    const auto places = field->places(request.epsilon, request.most);
    if (!places) return std::unexpected(places.error());
    return positions_at(*places, curves, job);
  }
  SpacingLimits limits;
  limits.widest = widest_for(length, request.count);
  limits.finest = limits.widest / kFiner;
  limits.share = request.share;
  limits.least_each = static_cast<double>(std::max<std::size_t>(request.least_each, 3));
  limits.is_finest_by_curve = request.rule == SamplingRule::refined;
  limits.corner_angle = request.corner_angle;
  if (request.rule != SamplingRule::curvature)
    return positions_by(spacings_of(curves, limits, job), curves, request, job);
  limits.share = request.turn;
  return positions_by(spacings_by_curvature(curves, limits), curves, request, job);
}

Expected<void> sample_unevenly(const Sources& sources, const SamplingRequest& request, const FeatureField* field,
                               Collector& out) {
  const std::vector<PlaneCurve>& curves = sources.curves.curves;
  if (request.count > std::min(kMostUneven, request.most)) return too_many_for_rule();
  std::vector<MeasuredCurve> own;
  if (field == nullptr) {
    const double negligible = negligible_length(sources.curves, request);
    for (std::size_t i = 0; i < curves.size(); ++i)
      own.push_back(sources.measured(i, request, negligible, out.job()));
  }
  const std::span<const MeasuredCurve> measured_curves = field != nullptr ? field->measured() : own;
  double all = 0.0;
  for (const MeasuredCurve& curve : measured_curves) all += curve.length();
  if (!std::isfinite(all)) return beyond_range();
  Positions positions(curves.size());
  if (all > 0.0) {
    auto found = uneven_positions(measured_curves, all, request, field, out.job());
    if (!found) return std::unexpected(found.error());
    positions = *std::move(found);
  }
  for (std::size_t i = 0; i < measured_curves.size(); ++i)
    add_stretches(measured_curves[i], curves[i], positions[i], out);
  return {};
}

std::size_t piece_count(const CurveSet& curves) {
  std::size_t out = 0;
  for (const PlaneCurve& curve : curves.curves) out += curve.piece_count();
  return out;
}

/// True if the rule `refined` would add nothing to these polylines, because no side is longer than it allows.
bool have_short_sides(const CurveSet& curves, const SamplingRequest& request) {
  struct Sides {
    double all = 0.0;
    double longest = 0.0;
  };
  std::vector<Sides> sides(curves.curves.size());
  parallel_for(sides.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<Vec2>& points = curves.curves[i].points();
      for (std::size_t k = 1; k < points.size(); ++k) {
        const Vec2 side = points[k] - points[k - 1];
        const double size = std::sqrt(dot(side, side));
        sides[i].all += size;
        sides[i].longest = std::max(sides[i].longest, size);
      }
    }
  });
  double all = 0.0;
  for (const Sides& curve : sides) all += curve.all;
  if (!std::isfinite(all)) return false;
  const double widest = widest_for(all, request.count);
  const auto least_each = static_cast<double>(std::max<std::size_t>(request.least_each, 1));
  return std::ranges::all_of(
      sides, [&](const Sides& curve) { return curve.longest <= std::min(widest, curve.all / least_each); });
}

Expected<SampledCurves> sample_each(const Sources& sources, const SamplingRequest& request, const FeatureField* field,
                                    JobControl* job) {
  using Rule = SamplingRule;
  Collector out(job, sources.network != nullptr);
  const bool is_large = request.rule == Rule::refined && piece_count(sources.curves) > kMostAdaptivePieces;
  const bool is_even = request.rule == Rule::spacing || request.rule == Rule::count || is_large;
  const bool is_at_vertices =
      request.rule == Rule::vertices || (is_large && sources.network == nullptr &&
                                         std::ranges::all_of(sources.curves.curves, &PlaneCurve::is_polyline) &&
                                         have_short_sides(sources.curves, request));
  auto done = is_at_vertices ? sample_vertices(sources.curves, request, out)
              : is_even      ? sample_evenly(sources, request, out)
                             : sample_unevenly(sources, request, field, out);
  if (!done) return std::unexpected(done.error());
  if (!out.are_finite()) return beyond_range();
  return std::move(out).result();
}

/// Converts samples of arcs to samples of the curves that run along them.
SampledCurves walked(const CurveNetwork& network, const SampledCurves& arcs) {
  SampledCurves out;
  std::vector<std::vector<std::uint32_t>> samples(network.arcs.size());
  std::vector<std::uint32_t> at_node;
  const auto add = [&out](Vec2 p) {
    out.positions.push_back(p);
    return static_cast<std::uint32_t>(out.positions.size() - 1);
  };
  for (std::size_t arc = 0; arc < samples.size(); ++arc) {
    const SampledCurves::Chain& chain = arcs.chains[arc];
    const auto add_end = [&](std::size_t end, Vec2 p) {
      const std::uint32_t node = network.nodes[arc][end];
      if (node == CurveNetwork::kNoNode) return add(p);
      if (at_node.size() <= node) at_node.resize(node + std::size_t{1}, CurveNetwork::kNoNode);
      if (at_node[node] == CurveNetwork::kNoNode) at_node[node] = add(p);
      return at_node[node];
    };
    const std::span here = std::span(arcs.positions).subspan(chain.first, chain.count);
    const bool has_ends = network.nodes[arc][0] != CurveNetwork::kNoNode;
    // An arc that returns to its node has no second sample there.
    const bool comes_back = has_ends && network.nodes[arc][0] == network.nodes[arc][1];
    for (std::size_t k = 0; k < here.size(); ++k) {
      const bool is_last = k + 1 == here.size() && k > 0 && has_ends && !comes_back;
      samples[arc].push_back(k == 0 ? add_end(0, here[k]) : is_last ? add_end(1, here[k]) : add(here[k]));
    }
    if (comes_back && !here.empty()) samples[arc].push_back(samples[arc].front());
  }
  for (const CurveNetwork::Walk& walk : network.walks) {
    SampledCurves::Chain chain{walk.is_closed, out.order.size(), 0};
    const auto go = [&](std::uint32_t sample) {
      if (out.order.size() == chain.first || out.order.back() != sample) out.order.push_back(sample);
    };
    for (const CurveNetwork::Step& step : walk.steps) {
      const std::vector<std::uint32_t>& along = samples[step.arc];
      if (step.is_backwards)
        std::for_each(along.rbegin(), along.rend(), go);
      else
        std::ranges::for_each(along, go);
    }
    const auto has_end_twice = [&] {
      return walk.is_closed && out.order.size() > chain.first + 1 && out.order.back() == out.order[chain.first];
    };
    while (has_end_twice()) out.order.pop_back();
    chain.count = out.order.size() - chain.first;
    constexpr std::size_t kTriangle = 3;
    if (chain.count < kTriangle) chain.is_closed = false;
    if (chain.count < 2)
      out.order.resize(chain.first);
    else
      out.chains.push_back(chain);
  }
  return out;
}

}  // namespace

SamplingRequest default_sampling(const CurveSet& curves) {
  const std::size_t pieces = piece_count(curves);
  const bool is_straight = std::ranges::all_of(curves.curves, &PlaneCurve::is_polyline);
  if (!is_straight) {
    const auto rule = pieces <= kMostAdaptivePieces ? SamplingRule::adaptive : SamplingRule::count;
    return {.rule = rule, .count = kUsualSamples, .least_each = 8};
  }
  // A curve with so many vertices is already sampled; only much longer sides are divided.
  constexpr std::size_t kCoarse = 100;
  constexpr std::size_t kAround = 16;
  constexpr std::size_t kMostRefined = 3'000'000;
  const bool is_dense = pieces >= kUsualSamples;
  if (curves.curves.empty() || pieces + kAround * curves.curves.size() > kMostRefined)
    return {.rule = SamplingRule::vertices};
  return {.rule = SamplingRule::refined, .count = is_dense ? kCoarse : kUsualSamples, .least_each = kAround};
}

std::span<const SamplingRuleDescriptor> sampling_rules() {
  static constexpr std::array<SamplingRuleDescriptor, 7> kRules{{
      {SamplingRule::vertices, "vertices", "At the vertices",
       "The ends of the pieces that the curves consist of, and nothing between"},
      {SamplingRule::spacing, "spacing", "By distance", "Evenly along the curves, so far apart at most"},
      {SamplingRule::count, "number", "By number", "Evenly along the curves, so many at most"},
      {SamplingRule::adaptive, "nearness", "Denser where curves are near",
       "About so many, and more where parts of the curves are near to each other"},
      {SamplingRule::curvature, "curvature", "Denser where curves bend", "About so many, and more in bends"},
      {SamplingRule::feature_size, "feature-size", "By local feature size",
       "An epsilon-sample, as the theorems of crust and axis ask for it: by the distance of the curves to their own "
       "axis, which finer samples show"},
      {SamplingRule::refined, "refined", "At and between the vertices",
       "The ends of the pieces that the curves consist of, and samples between them where they are far apart"},
  }};
  return kRules;
}

Expected<void> check(const SamplingRequest& request) {
  const auto in = [](double x, double low, double high) { return x >= low && x <= high; };
  const auto usage = [](std::string text) { return refused(ErrorCode::usage, std::move(text)); };
  using Rule = SamplingRule;
  if (request.rule == Rule::spacing && !(request.spacing > 0.0 && std::isfinite(request.spacing)))
    return usage("the spacing of samples must be positive");
  if ((request.rule == Rule::count || request.rule >= Rule::adaptive) && request.count == 0)
    return usage("the number of samples must be positive");
  if (request.rule == Rule::curvature && !in(request.turn, kLeastTurn, kMostTurn))
    return usage("the turn between samples must be from 0.06 to 183 degrees");
  if (request.rule == Rule::feature_size && !in(request.epsilon, kLeastEpsilon, kMostEpsilon))
    return usage("epsilon must be from 0.01 to 1");
  if (!in(request.corner_angle, 0.0, kMostTurn)) return usage("the angle of corners must be from 0 to 183 degrees");
  if (!(request.corner_radius >= 0.0 && std::isfinite(request.corner_radius)))
    return usage("the radius of corners must not be negative");
  if (!in(request.jitter, 0.0, kMostJitter)) return usage("the jitter must be from 0 to 100");
  return {};
}

namespace {

/// `field` is needed for the rule `feature_size`.
Expected<SampledCurves> sample_by(const CurveSet& curves, const SamplingRequest& request, const FeatureField* field,
                                  JobControl* job) {
  if (auto good = check(request); !good) return std::unexpected(good.error());
  if (request.corner_radius > 0.0) {
    SamplingRequest rest = request;
    rest.corner_radius = 0.0;
    return sample_by(with_round_corners(curves, request.corner_angle, request.corner_radius), rest, field, job);
  }
  const auto network = network_of(curves.curves, curves.resolution, job);
  const CurveSet arcs{.curves = network ? network->arcs : std::vector<PlaneCurve>{}};
  auto each = sample_each({network ? arcs : curves, network ? &*network : nullptr}, request, field, job);
  if (!each) return each;
  SampledCurves samples = network ? walked(*network, *each) : *std::move(each);
  if (auto fits = check_count(static_cast<double>(samples.positions.size() + curves.points.size()), request); !fits)
    return std::unexpected(fits.error());
  if (!std::ranges::all_of(curves.points, [](Vec2 p) { return is_finite(p); })) return beyond_range();
  samples.positions.insert(samples.positions.end(), curves.points.begin(), curves.points.end());
  jitter(samples, request.jitter, request.seed);
  return samples;
}

}  // namespace

Expected<SampledCurves> sample_by_field(const CurveSet& curves, const SamplingRequest& request,
                                        const FeatureField& field, JobControl* job) {
  return sample_by(curves, request, &field, job);
}

Expected<SampledCurves> sample(const CurveSet& curves, const SamplingRequest& request, const FeatureSizes& sizes,
                               JobControl* job) {
  if (auto good = check(request); !good) return std::unexpected(good.error());
  if (request.rule != SamplingRule::feature_size) return sample_by(curves, request, nullptr, job);
  if (!sizes) return refused(ErrorCode::usage, "there is nothing here to measure feature sizes with");
  if (request.count > std::min(kMostUneven, request.most)) return too_many_for_rule();
  const auto field = FeatureField::of(curves, request, sizes, job, request.most);
  if (!field) return std::unexpected(field.error());
  return sample_by(curves, request, &*field, job);
}

}  // namespace mes

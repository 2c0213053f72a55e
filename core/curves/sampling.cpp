// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/sampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"

namespace mes {
namespace {

constexpr std::size_t kSamplesOfADrawing = 400;
// Of the adaptive rule: how many samples may lie where one would.
constexpr double kFiner = 8.0;
// What has more pieces is sampled evenly when it is opened, in time that grows with their number and no faster.
constexpr std::size_t kMostAdaptivePieces = 20'000;

std::unexpected<Error> refused(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text)});
}

std::unexpected<Error> beyond_range() {
  return refused(ErrorCode::bad_input, "the curves reach beyond the range of numbers");
}

/// What the number of samples of a curve depends on.
struct Outline {
  std::vector<double> stretches;  // lengths
  double length = 0.0;
  bool is_closed = false;
  bool is_straight = false;
};

Outline outline_of(const MeasuredCurve& curve) {
  Outline out;
  for (const Stretch& stretch : curve.stretches) out.stretches.push_back(stretch.length);
  out.length = curve.length();
  out.is_closed = curve.is_closed;
  out.is_straight = curve.stretches.size() == 1 && std::ranges::all_of(curve.pieces, [](const Piece& piece) {
                      return piece.kind == PieceKind::line;
                    });
  return out;
}

constexpr double kRounding = 1e-9;

/// Intervals of a stretch of a curve at a spacing. A length that is a multiple of it up to rounding counts as one.
double intervals_of(double length, double spacing) {
  return std::max(1.0, std::ceil(length / spacing * (1.0 - kRounding)));
}

double spacing_for(const Outline& curve, double spacing, std::size_t least_each) {
  const bool is_bounded = curve.is_closed || !curve.is_straight;
  if (!is_bounded || curve.stretches.empty()) return spacing;
  return std::min(spacing, curve.length / static_cast<double>(std::max<std::size_t>(least_each, 3)));
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

/// The least spacing, up to rounding, that gives at most so many samples; the longest curve where none does.
double spacing_for_count(const std::vector<Outline>& curves, std::size_t count, std::size_t least_each) {
  double all = 0.0;
  for (const Outline& curve : curves) all += curve.length;
  if (all == 0.0) return 1.0;
  const auto wanted = static_cast<double>(std::max<std::size_t>(count, 1));
  double low = 0.5 * all / wanted;  // too many
  double high = all;                // as few as there can be
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps; ++step) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (sample_count(curves, middle, least_each) > wanted ? low : high) = middle;
  }
  // Lengths that are equal up to rounding are on the same side of it.
  return high * (1.0 + 2.0 * kRounding);
}

/// Adds samples, and takes those of the curve last begun that come twice out again.
class Collector {
 public:
  void begin_curve(bool is_closed) { out_.chains.push_back({is_closed, out_.positions.size(), 0}); }
  void add(Vec2 position) { out_.positions.push_back(position); }

  void end_curve() {
    SampledCurves::Chain& chain = out_.chains.back();
    remove_repetitions(chain.first);
    chain.count = out_.positions.size() - chain.first;
    if (chain.count < 2) {
      out_.chains.pop_back();
    } else if (chain.count < 3) {
      chain.is_closed = false;
    }
  }

  bool are_finite() const {
    return std::ranges::all_of(out_.positions, [](Vec2 p) { return is_finite(p); });
  }
  std::size_t size() const { return out_.positions.size(); }
  SampledCurves result() && { return std::move(out_); }

 private:
  void remove_repetitions(std::size_t first) {
    const auto begin = out_.positions.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<std::size_t> order(out_.positions.size() - first);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
      const Vec2 p = out_.positions[first + a];
      const Vec2 q = out_.positions[first + b];
      return lexicographically_less(p, q) || (p == q && a < b);
    });
    std::vector<bool> is_repeated(order.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i)
      is_repeated[order[i]] = out_.positions[first + order[i - 1]] == out_.positions[first + order[i]];
    std::size_t next = 0;
    const auto kept_end =
        std::remove_if(begin, out_.positions.end(), [&](Vec2 /*position*/) { return is_repeated[next++]; });
    out_.positions.erase(kept_end, out_.positions.end());
  }

  SampledCurves out_;
};

void add_vertices(const PlaneCurve& curve, Collector& out) {
  out.begin_curve(curve.is_closed());
  out.add(curve.start());
  // The last one of a closed curve is its start, which comes out again.
  curve.for_each_piece([&](const Piece& piece) { out.add(piece.to()); });
  out.end_curve();
}

/// Samples at lengths of arc from the beginning of a stretch, in order; at its end too where `adds_end`.
void add_places(const MeasuredCurve& curve, const Stretch& stretch, const std::vector<double>& places, bool adds_end,
                Collector& out) {
  std::size_t piece = stretch.first;
  double before = 0.0;
  const std::size_t last = stretch.first + stretch.count - 1;
  for (const double wanted : places) {
    while (piece < last && wanted >= before + curve.lengths[piece].total()) before += curve.lengths[piece++].total();
    out.add(curve.pieces[piece].at(curve.lengths[piece].parameter_at(wanted - before)));
  }
  if (adds_end) out.add(curve.pieces[last].to());
}

std::vector<double> even_places(double length, double intervals) {
  std::vector<double> out;
  for (double i = 0.0; i < intervals; ++i) out.push_back(length * (i / intervals));
  return out;
}

/// The length of pieces that make no corners: a hundredth of about what lies between samples.
double negligible_length(const CurveSet& curves, const SamplingRequest& request) {
  double spacing = request.spacing;
  if (request.rule != SamplingRule::spacing) {
    spacing = 0.0;
    for (const PlaneCurve& curve : curves.curves)
      curve.for_each_piece([&](const Piece& piece) { spacing += distance(piece.from(), piece.to()); });
    spacing /= static_cast<double>(std::max<std::size_t>(request.count, 1));
  }
  constexpr double kShare = 0.01;
  return kShare * spacing;
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

/// A curve by the spacings of its stretches.
void add_adaptively(const MeasuredCurve& curve, const PlaneCurve& source, const std::vector<StretchSpacing>& spacings,
                    Collector& out) {
  out.begin_curve(curve.is_closed);
  if (curve.stretches.empty()) out.add(source.start());
  for (std::size_t i = 0; i < curve.stretches.size(); ++i) {
    const bool adds_end = !curve.is_closed && i + 1 == curve.stretches.size();
    add_places(curve, curve.stretches[i], spacings[i].places(), adds_end, out);
  }
  out.end_curve();
}

Expected<void> check_count(double count, const SamplingRequest& request) {
  if (count <= static_cast<double>(request.most)) return {};
  return refused(
      ErrorCode::bad_input,
      fmt::format("the curves would have {:.6g} samples; {} are as many as there may be", count, request.most));
}

Expected<void> sample_vertices(const CurveSet& curves, const SamplingRequest& request, Collector& out) {
  double count = 0.0;
  for (const PlaneCurve& curve : curves.curves)
    count += static_cast<double>(curve.piece_count()) + (curve.is_closed() ? 0.0 : 1.0);
  if (auto fits = check_count(count, request); !fits) return fits;
  for (const PlaneCurve& curve : curves.curves) add_vertices(curve, out);
  return {};
}

Expected<void> sample_evenly(const CurveSet& curves, const SamplingRequest& request, Collector& out) {
  std::vector<Outline> outlines;
  outlines.reserve(curves.curves.size());
  const double negligible = negligible_length(curves, request);
  for (const PlaneCurve& curve : curves.curves) {
    outlines.push_back(outline_of(measured(curve, request.corner_angle, negligible)));
    if (!std::isfinite(outlines.back().length)) return beyond_range();
  }
  const double spacing = request.rule == SamplingRule::spacing
                             ? request.spacing
                             : spacing_for_count(outlines, request.count, request.least_each);
  if (auto fits = check_count(sample_count(outlines, spacing, request.least_each), request); !fits) return fits;
  for (const PlaneCurve& curve : curves.curves)
    add_evenly(measured(curve, request.corner_angle, negligible), curve, spacing, request, out);
  return {};
}

Expected<void> sample_adaptively(const CurveSet& curves, const SamplingRequest& request, Collector& out) {
  const double negligible = negligible_length(curves, request);
  std::vector<MeasuredCurve> measured_curves;
  double all = 0.0;
  for (const PlaneCurve& curve : curves.curves) {
    measured_curves.push_back(measured(curve, request.corner_angle, negligible));
    all += measured_curves.back().length();
  }
  if (!std::isfinite(all)) return beyond_range();
  SpacingLimits limits;
  limits.widest = all / static_cast<double>(std::max<std::size_t>(request.count, 1));
  limits.finest = limits.widest / kFiner;
  limits.share = request.share;
  limits.least_each = static_cast<double>(std::max<std::size_t>(request.least_each, 3));
  const auto spacings = all > 0.0 ? spacings_of(measured_curves, limits)
                                  : std::vector<std::vector<StretchSpacing>>(curves.curves.size());
  double count = 0.0;
  for (const std::vector<StretchSpacing>& curve : spacings)
    for (const StretchSpacing& stretch : curve) count += stretch.count();
  if (auto fits = check_count(count, request); !fits) return fits;
  for (std::size_t i = 0; i < measured_curves.size(); ++i)
    add_adaptively(measured_curves[i], curves.curves[i], spacings[i], out);
  return {};
}

}  // namespace

SamplingRequest default_sampling(const CurveSet& curves) {
  std::size_t vertices = 0;
  bool is_straight = true;
  for (const PlaneCurve& curve : curves.curves) {
    vertices += curve.piece_count();
    is_straight = is_straight && curve.is_polyline();
  }
  if (is_straight && vertices >= kSamplesOfADrawing) return {.rule = SamplingRule::vertices};
  const auto rule = vertices <= kMostAdaptivePieces ? SamplingRule::adaptive : SamplingRule::count;
  return {.rule = rule, .count = kSamplesOfADrawing, .least_each = 8};
}

Expected<SampledCurves> sample(const CurveSet& curves, const SamplingRequest& request) {
  if (request.rule == SamplingRule::spacing && !(request.spacing > 0.0))
    return refused(ErrorCode::usage, "the spacing of samples must be positive");
  Collector out;
  auto done = request.rule == SamplingRule::vertices   ? sample_vertices(curves, request, out)
              : request.rule == SamplingRule::adaptive ? sample_adaptively(curves, request, out)
                                                       : sample_evenly(curves, request, out);
  if (!done) return std::unexpected(done.error());
  if (auto fits = check_count(static_cast<double>(out.size() + curves.points.size()), request); !fits)
    return std::unexpected(fits.error());
  for (const Vec2 point : curves.points) out.add(point);
  if (!out.are_finite()) return beyond_range();
  return std::move(out).result();
}

}  // namespace mes

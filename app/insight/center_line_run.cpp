// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/center_line_run.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/base/geometry/box2.h"
#include "core/base/geometry/quick_length.h"
#include "core/curves/curve.h"
#include "core/curves/feature_field.h"
#include "core/resampling/resampling.h"
#include "core/structures/density/sample_sizes.h"
#include "core/structures/outline/outline_center_lines.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {
namespace {

std::unexpected<Error> no_line(ErrorCode code, std::string_view text) {
  return std::unexpected(Error{code, std::string(text), {}, 0, 0});
}

constexpr std::string_view kNothingEnclosed = "there is no centre line: no closed outline encloses anything";

/// Samples of a strip that is so many times as long as it is wide, over that number: with an epsilon of 1/4 and feature
/// sizes of half the width, both long sides have four samples on a width.
constexpr std::size_t kSamplesOfRatio = 8;
/// A larger ratio is the rounding of a polygon without a width.
constexpr double kNoWidth = 1e12;

/// Length over width of the strip around a polygon, along the principal axis of its vertices; 0 for other curves.
double strip_ratio(const PlaneCurve& curve) {
  if (!curve.is_polyline() || !curve.is_closed()) return 0.0;
  // The last point is the first one again, which would turn the axis.
  const std::span<const Vec2> points = std::span(curve.points()).first(curve.points().size() - 1);
  Vec2 middle{};
  for (const Vec2 p : points) middle = middle + 1.0 / static_cast<double>(points.size()) * p;
  double size = 0.0;
  for (const Vec2 p : points) size = std::max(size, quick_length(p - middle));
  if (!(size > 0.0)) return 0.0;
  double difference = 0.0;
  double product = 0.0;
  for (const Vec2 p : points) {
    const Vec2 q{(p.x - middle.x) / size, (p.y - middle.y) / size};
    difference += q.x * q.x - q.y * q.y;
    product += q.x * q.y;
  }
  const double angle = 0.5 * std::atan2(2.0 * product, difference);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  Box2 box;
  for (const Vec2 p : points) box.add(Vec2{dot(along, p - middle), cross(along, p - middle)});
  return box.width() / box.height();
}

void keep_curves(std::shared_ptr<const CurveSet>& curves, std::vector<Vec2> points, auto is_kept) {
  auto kept = std::make_shared<CurveSet>(CurveSet{{}, std::move(points), curves->resolution});
  std::ranges::copy_if(curves->curves, std::back_inserter(kept->curves), is_kept);
  curves = std::move(kept);
}

void leave_out_lines_beside_areas(std::shared_ptr<const CurveSet>& curves, std::vector<std::string>& remarks) {
  const auto open = static_cast<std::size_t>(
      std::ranges::count_if(curves->curves, [](const PlaneCurve& curve) { return !curve.is_closed(); }));
  const std::size_t points = curves->points.size();
  if (open == curves->curves.size() || open + points == 0) return;
  const std::string lines = open == 0 ? std::string() : counted(open, "open line");
  const std::string others = points == 0 ? std::string() : counted(points, "point");
  remarks.push_back(fmt::format("{}{}{} {} left out, since there are closed outlines", lines,
                                lines.empty() || others.empty() ? "" : " and ", others,
                                open + points == 1 ? "is" : "are"));
  keep_curves(curves, {}, &PlaneCurve::is_closed);
}

Expected<void> leave_out_flat(std::shared_ptr<const CurveSet>& curves, std::vector<std::string>& remarks) {
  const auto is_flat = [](const PlaneCurve& curve) { return strip_ratio(curve) > kNoWidth; };
  const auto flat = static_cast<std::size_t>(std::ranges::count_if(curves->curves, is_flat));
  if (flat == 0) return {};
  if (flat == curves->curves.size())
    return no_line(ErrorCode::bad_input, flat == 1 ? std::string("the outline has no width")
                                                   : fmt::format("its {} outlines have no width", flat));
  remarks.push_back(flat == 1 ? std::string("an outline without a width is left out")
                              : fmt::format("{} outlines without a width are left out", flat));
  keep_curves(curves, curves->points, [&](const PlaneCurve& curve) { return !is_flat(curve); });
  return {};
}

std::vector<std::string> remarks_on(const OutlineFaults& faults) {
  std::vector<std::string> out;
  if (faults.same != 0)
    out.push_back(faults.same == 1 ? std::string("an outline repeats another one, and counts once")
                                   : fmt::format("{} outlines repeat others, and count once", faults.same));
  std::string overlap;
  if (faults.crossings != 0)
    overlap = "sides of outlines cross " +
              (faults.crossings == 1 ? std::string("once") : fmt::format("{} times", faults.crossings));
  else if (faults.overlaps != 0)
    overlap = "outlines overlap along " + counted(faults.overlaps, "side");
  if (!overlap.empty()) out.push_back(overlap + ", and what an even number of outlines encloses counts as outside");
  if (faults.repeated != 0)
    out.push_back(fmt::format("outlines run along {} of their own again, and such sides may bound nothing",
                              faults.repeated == 1 ? "a side" : fmt::format("{} sides", faults.repeated)));
  return out;
}

/// The smallest angle at a vertex of a polygon; that of other curves is not looked for.
double least_angle(const PlaneCurve& curve) {
  double out = std::numbers::pi;
  if (!curve.is_polyline() || !curve.is_closed()) return out;
  const std::span<const Vec2> points = std::span(curve.points()).first(curve.piece_count());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 back = points[(i + points.size() - 1) % points.size()] - points[i];
    const Vec2 on = points[(i + 1) % points.size()] - points[i];
    if (dot(back, on) > 0.0) out = std::min(out, std::atan2(std::abs(cross(back, on)), dot(back, on)));
  }
  return out;
}

/// A sentence on an outline that is too long and thin, or has too sharp a corner, to be sampled; empty if there is none.
std::string about_thin(std::span<const PlaneCurve> curves) {
  // Samples reach a corner up to the least distance between them over its angle.
  constexpr double kSharp = 1.0 / 500.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string name = curves.size() == 1 ? std::string("the outline") : fmt::format("outline {}", i + 1);
    if (const double ratio = strip_ratio(curves[i]); kSamplesOfRatio * ratio > kMostOutlineSamples)
      return fmt::format("{} is {:.3g} times as long as it is wide", name, ratio);
    if (const double angle = least_angle(curves[i]); angle < kSharp)
      return fmt::format("{} has a corner of {:.2g} degrees", name, angle * 180.0 / std::numbers::pi);
  }
  return {};
}

/// Whether there are so many more samples than sides that part of an outline must be very thin. The exact axis takes
/// less time there.
bool is_worth_exact(std::span<const PlaneCurve> curves, std::size_t samples) {
  constexpr std::size_t kMany = 50'000;
  constexpr std::size_t kOfSide = 100;
  std::size_t pieces = 0;
  for (const PlaneCurve& curve : curves) pieces += curve.piece_count();
  return samples > kMany && samples / kOfSide > pieces;
}

/// The contours of data without curves as outlines, if the samples do not stand for them, as where a table has only the
/// corners of a ring; else null.
std::shared_ptr<const CurveSet> coarse_contours(const SampleData& data, JobControl& job) {
  constexpr std::size_t kMost = 20'000;  // longer lists are samples
  const auto is_ring = [](const SampleData::Contour& contour) { return contour.closed && contour.points.size() > 2; };
  if (data.contours.empty() || data.positions.size() > kMost || !std::ranges::all_of(data.contours, is_ring))
    return nullptr;
  auto out = std::make_shared<CurveSet>();
  std::vector<bool> is_on_contour(data.positions.size(), false);
  for (const SampleData::Contour& contour : data.contours) {
    PlaneCurve curve(data.positions[contour.points.front()]);
    for (const std::uint32_t i : contour.points) {
      is_on_contour[i] = true;
      if (data.positions[i] != curve.end()) curve.line_to(data.positions[i]);
    }
    if (curve.piece_count() < 2) return nullptr;
    curve.close();
    out->curves.push_back(std::move(curve));
  }
  if (std::ranges::find(is_on_contour, false) != is_on_contour.end()) return nullptr;
  SampleSizes sizes(job);
  const auto field = FeatureField::of(
      *out, {.rule = SamplingRule::feature_size, .count = kUsualSamples},
      [&sizes](std::span<const Vec2> positions) { return sizes.of(positions); }, &job, kMostOutlineSamples);
  if (field && field->standing(data.positions, &job).epsilon <= 1.0) return nullptr;
  return out;
}

}  // namespace

CenterLineWish wish_of(const ComputationSettings& settings, const Annotations& annotations) {
  CenterLineWish out;
  out.lambda_limit = settings[Parameter::lambda_limit];
  out.request.least_salience = settings[Parameter::center_line_pruning];
  out.request.most = static_cast<std::size_t>(settings[Parameter::center_line_branches]);
  out.request.between = center_line_ends(annotations);
  return out;
}

Expected<CenterLineInput> input_for_center_lines(const SampleData& data, CenterLineBasis basis, JobControl& job) {
  CenterLineInput out{.is_exact = basis == CenterLineBasis::outlines};
  std::shared_ptr<const CurveSet> curves = data.source ? data.source->curves : nullptr;
  if (!curves && basis == CenterLineBasis::new_samples) {
    curves = coarse_contours(data, job);
    if (curves) out.remarks.emplace_back("the samples are too few for their contours, which are taken as outlines");
  }
  if (!curves) {
    out.data = data;
    return out;
  }
  if (basis != CenterLineBasis::own_samples) {
    leave_out_lines_beside_areas(curves, out.remarks);
    if (auto some = leave_out_flat(curves, out.remarks); !some) return std::unexpected(some.error());
  }
  // Two open lines may be the banks of something; one is not.
  if (curves->points.empty() && curves->curves.size() == 1 && !curves->curves.front().is_closed())
    return no_line(ErrorCode::cannot_compute, kNothingEnclosed);
  const OutlineFaults faults = faults_of_outlines(curves->curves, job);
  std::ranges::move(remarks_on(faults), std::back_inserter(out.remarks));
  if (basis == CenterLineBasis::new_samples) {
    // Samples of outlines that cross say nothing of what lies inside.
    std::string reason = faults.crossings != 0  ? "they cross"
                         : faults.overlaps != 0 ? "they overlap"
                         : faults.repeated != 0 ? "they run along themselves"
                                                : about_thin(curves->curves);
    if (reason.empty()) {
      const SamplingRequest request{
          .rule = SamplingRule::feature_size,
          .count = std::max(kUsualSamples, std::min(data.positions.size(), kMostOutlineSamples)),
          .most = kMostOutlineSamples};
      auto taken = take_samples(curves, request, job);
      if (taken && !is_worth_exact(curves->curves, taken->data.positions.size())) {
        out.data = std::move(taken->data);
        out.data.map = data.map;
        return out;
      }
      reason = taken ? "a part of them is very thin" : taken.error().text;
    }
    out.is_exact = true;
    out.remarks.push_back("the lines are those of the exact axis of the outlines, because " + reason);
  }
  out.data = data;
  if (!data.source || curves != data.source->curves) {
    CurveSource source = data.source ? *data.source : CurveSource{};
    source.curves = std::move(curves);
    out.data.source = std::make_shared<const CurveSource>(std::move(source));
  }
  return out;
}

Expected<CenterLines> CenterLineFinder::find(const SampleData& data, const CenterLineWish& wish, JobControl& job,
                                             const std::function<void(std::string_view)>& on_task) {
  ComputationSettings settings;
  settings[Parameter::lambda_limit] = wish.lambda_limit;
  const auto& lambda = bench_.get<LambdaAxis>();
  const auto& angle = bench_.get<AngleAxis>();
  const auto& outline = bench_.get<OutlineAxis>();
  const std::vector<std::string_view> needed = wish.is_exact ? std::vector<std::string_view>{outline.id()}
                                                             : std::vector<std::string_view>{lambda.id(), angle.id()};
  if (auto good = bench_.need(needed); !good) return std::unexpected(good.error());
  bench_.choose(settings);
  if (auto good = bench_.load(data); !good) return std::unexpected(good.error());
  bench_.set_on_task(on_task);
  if (auto good = bench_.run_or_throw(job); !good) return std::unexpected(good.error());
  const auto& crust = bench_.get<OneStepCrust>();
  const auto branches = [&] { return branches_of(lambda, bench_.get<InnerBalls>(), lambda, angle, kLeastBranch); };
  CenterLines out = wish.is_exact ? center_lines_of(outline, wish.request, job)
                                  : center_lines_of(lambda, crust, branches(), wish.request, job);
  if (out.unjoined != 0 && out.lines.empty())
    return no_line(ErrorCode::usage,
                   "the two points are nearest to the same end of the axis, or to ends of two shapes");
  if (out.lines.empty()) {
    if (wish.is_exact && outline.graph().regions == 0) return no_line(ErrorCode::cannot_compute, kNothingEnclosed);
    const std::string reason = wish.is_exact ? "" : lambda.reason();
    const std::string usual = out.points == 0 && !wish.is_exact
                                  ? "nothing is enclosed"
                                  : "every shape is so compact that its pruned axis is a point";
    return no_line(ErrorCode::cannot_compute, "there is no centre line: " + (reason.empty() ? usual : reason));
  }
  smooth(out, wish.tolerance);
  // Pruned arms reach up to 1 + salience radii; a ray beside them may be somewhat longer.
  const double most = 2.0 * (1.0 + wish.request.least_salience);
  if (wish.is_extended && wish.is_exact) extend_to_outline(out, outline, most);
  if (wish.is_extended && !wish.is_exact) extend_to_curve(out, bench_.get<Delaunay>(), crust, most);
  return out;
}

}  // namespace mes

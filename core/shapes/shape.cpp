// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/shape.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/coordinate_range.h"
#include "core/base/rng.h"
#include "core/curves/sampling.h"
#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

/// Evenly, by their number or spacing, or more densely where it is narrow.
SamplingRequest sampling_of(const ShapeSampling& wish) {
  constexpr std::size_t kSamples = 400;
  constexpr std::size_t kLeastEach = 8;
  SamplingRequest out{.most = kMostShapeSamples};
  if (wish.spacing) {
    out.rule = SamplingRule::spacing;
    out.spacing = *wish.spacing;
  } else if (wish.samples) {
    out.rule = SamplingRule::count;
    out.count = *wish.samples;
  } else {
    out.rule = SamplingRule::adaptive;
    out.count = kSamples;
    out.least_each = kLeastEach;
  }
  return out;
}

double length_along(const SampledCurves& samples) {
  double out = 0.0;
  for (const SampledCurves::Chain& chain : samples.chains) {
    const auto at = [&](std::size_t i) { return samples.positions[chain.first + i % chain.count]; };
    for (std::size_t i = 0; i + (chain.is_closed ? 0 : 1) < chain.count; ++i) out += distance(at(i), at(i + 1));
  }
  return out;
}

/// Between samples along curves, or between points that were spread evenly over their extent.
double mean_spacing(const SampledCurves& samples) {
  const std::size_t count = samples.positions.size();
  if (count < 2) return 0.0;
  if (!samples.chains.empty()) return length_along(samples) / static_cast<double>(count);
  Vec2 low = samples.positions.front();
  Vec2 high = low;
  for (const Vec2 p : samples.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double area = (high.x - low.x) * (high.y - low.y);
  return area > 0.0 ? std::sqrt(area / static_cast<double>(count))
                    : distance(low, high) / static_cast<double>(count - 1);
}

void jitter(SampledCurves& samples, const ShapeSampling& wish) {
  if (wish.jitter == 0.0) return;
  const double reach = wish.jitter * mean_spacing(samples);
  // Another sequence than that of the points themselves.
  constexpr std::uint64_t kOther = 0x6a09e667f3bcc909;
  Rng random(wish.seed ^ kOther);
  for (Vec2& p : samples.positions) {
    const double angle = random.uniform(0.0, kTurn);
    const double away = reach * std::sqrt(random.uniform());
    p = p + away * Vec2{std::cos(angle), std::sin(angle)};
  }
}

SampleData data_of(SampledCurves samples, std::vector<Disk> balls) {
  SampleData out;
  // A coordinate that is nothing but rounding beside the others is zero.
  int most = Magnitudes{}.most;
  for (const Vec2 p : samples.positions)
    for (const double x : {p.x, p.y})
      if (x != 0.0) most = std::max(most, exponent_of(x));
  for (Vec2& p : samples.positions) p = {without_traces(p.x, most), without_traces(p.y, most)};
  for (const SampledCurves::Chain& chain : samples.chains) {
    SampleData::Contour& contour = out.contours.emplace_back(SampleData::Contour{chain.is_closed, {}});
    for (std::size_t i = 0; i < chain.count; ++i)
      contour.points.push_back(static_cast<std::uint32_t>(chain.first + i));
  }
  out.positions = std::move(samples.positions);
  out.balls = std::move(balls);
  return out;
}

Expected<void> check(const ShapeDescriptor& shape, const ShapeSampling& wish) {
  if (wish.samples && wish.spacing) return impossible("either the number of samples or their spacing, not both");
  if (wish.spacing && shape.points != 0)
    return impossible(fmt::format("{} has no curve along which there is a spacing", shape.id));
  if (wish.spacing && !(*wish.spacing > 0.0 && std::isfinite(*wish.spacing)))
    return impossible("a spacing is a positive number");
  if (wish.samples && (*wish.samples == 0 || *wish.samples > kMostShapeSamples))
    return impossible(fmt::format("there are from 1 to {} samples", kMostShapeSamples));
  if (!(wish.jitter >= 0.0 && wish.jitter <= 100.0)) return impossible("a jitter is a number from 0 to 100");
  return {};
}

}  // namespace

std::unexpected<Error> impossible(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text)});
}

std::span<const ShapeDescriptor> shapes() {
  static const std::vector<ShapeDescriptor> all = [] {
    std::vector<ShapeDescriptor> out;
    for (auto family : {round_shapes, cornered_shapes, formula_shapes, point_shapes})
      for (ShapeDescriptor& shape : family()) out.push_back(std::move(shape));
    return out;
  }();
  return all;
}

const ShapeDescriptor* find_shape(std::string_view id) {
  const auto found = std::ranges::find(shapes(), id, &ShapeDescriptor::id);
  return found == shapes().end() ? nullptr : &*found;
}

ShapeValues values_of(const ShapeDescriptor& shape) {
  ShapeValues out{.samples = shape.points};
  for (const ParameterDescriptor& parameter : shape.parameters) out.numbers.push_back(parameter.default_value);
  for (const FormulaParameter& formula : shape.formulas) out.formulas.emplace_back(formula.default_text);
  return out;
}

Expected<SampleData> make_shape(const ShapeDescriptor& shape, const ShapeRequest& request) {
  MES_ASSERT(request.values.numbers.size() == shape.parameters.size() &&
             request.values.formulas.size() == shape.formulas.size());
  if (auto good = check(shape, request.sampling); !good) return std::unexpected(good.error());
  ShapeValues values = request.values;
  if (request.sampling.samples && shape.points != 0) values.samples = *request.sampling.samples;
  values.seed = request.sampling.seed;
  auto made = shape.make(values);
  if (!made) return std::unexpected(made.error());
  auto samples = sample(made->curves, sampling_of(request.sampling));
  if (!samples) return std::unexpected(samples.error());
  jitter(*samples, request.sampling);
  SampledCurves centers;
  for (const Disk& ball : made->balls) centers.positions.push_back(ball.center);
  if (!made->balls.empty()) jitter(centers, request.sampling);
  for (std::size_t i = 0; i < made->balls.size(); ++i) made->balls[i].center = centers.positions[i];
  return data_of(*std::move(samples), std::move(made->balls));
}

}  // namespace mes

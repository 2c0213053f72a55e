// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/shape.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/assert.h"
#include "core/curves/jitter.h"
#include "core/curves/sampling.h"
#include "core/document/taken_samples.h"
#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

/// Even sampling by number or spacing, or by default one that is denser where the shape is narrow.
SamplingRequest sampling_of(const ShapeSampling& wish) {
  constexpr std::size_t kSamples = 400;
  constexpr std::size_t kLeastEach = 8;
  SamplingRequest out{.jitter = wish.jitter, .seed = wish.seed, .most = kMostShapeSamples};
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

Expected<void> check(const ShapeSampling& wish) {
  if (wish.samples && wish.spacing) return impossible("either the number of samples or their spacing, not both");
  if (wish.spacing && !(*wish.spacing > 0.0 && std::isfinite(*wish.spacing)))
    return impossible("a spacing must be a positive number");
  if (wish.samples && (*wish.samples == 0 || *wish.samples > kMostShapeSamples))
    return impossible(fmt::format("the number of samples must be from 1 to {}", kMostShapeSamples));
  if (!(wish.jitter >= 0.0 && wish.jitter <= 100.0)) return impossible("a jitter must be a number from 0 to 100");
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
  for (const FormulaParameter& formula : shape.formulas) out.formulas.push_back(formula.default_text);
  return out;
}

Expected<SampleData> sample_curves(const CurveSet& curves, const ShapeSampling& wish, JobControl* job) {
  if (auto good = check(wish); !good) return std::unexpected(good.error());
  const SamplingRequest sampling = sampling_of(wish);
  auto samples = sample(curves, sampling, {}, job);
  if (!samples) return std::unexpected(samples.error());
  return taken_from(std::make_shared<const CurveSet>(curves), *std::move(samples), sampling);
}

Expected<SampleData> make_shape(const ShapeDescriptor& shape, const ShapeRequest& request, JobControl* job) {
  MES_ASSERT(request.values.formulas.size() == shape.formulas.size());
  if (auto good = check(request.sampling); !good) return std::unexpected(good.error());
  if (request.sampling.spacing && shape.points != 0)
    return impossible(fmt::format("{} has no curve along which there is a spacing", shape.id));
  ShapeArguments arguments{.numbers = {},
                           .formulas = request.values.formulas,
                           .samples = request.values.samples,
                           .seed = request.sampling.seed};
  for (const Parameter& parameter : shape.parameters) arguments.numbers.push_back(request.values.numbers[parameter]);
  if (request.sampling.samples && shape.points != 0) arguments.samples = *request.sampling.samples;
  auto made = shape.make(arguments);
  if (job != nullptr) job->checkpoint();
  if (!made) return std::unexpected(made.error());
  const SamplingRequest sampling = sampling_of(request.sampling);
  auto samples = sample(made->curves, sampling, {}, job);
  if (!samples) return std::unexpected(samples.error());
  SampledCurves centers;
  for (const Disk& ball : made->balls) centers.positions.push_back(ball.center);
  if (!made->balls.empty()) jitter(centers, request.sampling.jitter, request.sampling.seed);
  for (std::size_t i = 0; i < made->balls.size(); ++i) made->balls[i].center = centers.positions[i];
  auto out = taken_from(std::make_shared<const CurveSet>(std::move(made->curves)), *std::move(samples), sampling);
  if (!out) return out;
  // Point sets are their own samples: no curve exists to resample.
  if (shape.points != 0) out->source.reset();
  out->balls = std::move(made->balls);
  return out;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/center_line_run.h"

#include <algorithm>
#include <utility>

#include "core/resampling/resampling.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

std::unexpected<Error> no_line(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text), {}, 0, 0});
}

}  // namespace

CenterLineWish wish_of(const ComputationSettings& settings) {
  CenterLineWish out;
  out.lambda_limit = settings[Parameter::lambda_limit];
  out.request.least_salience = settings[Parameter::center_line_pruning];
  out.request.most = static_cast<std::size_t>(settings[Parameter::center_line_branches]);
  return out;
}

SampleData samples_for_center_lines(const SampleData& data, JobControl& job, std::string& remark) {
  if (!data.source || !data.source->curves) return data;
  const SamplingRequest request{.rule = SamplingRule::feature_size,
                                .count = std::max(kUsualSamples, data.positions.size())};
  auto taken = take_samples(data.source->curves, request, job);
  if (!taken) {
    remark = "the outlines keep their samples: " + taken.error().text;
    return data;
  }
  taken->data.map = data.map;
  return std::move(taken->data);
}

Expected<CenterLines> compute_center_lines(const Registry& registry, const SampleData& data,
                                           const CenterLineWish& wish, JobControl& job,
                                           const std::function<void(std::string_view)>& on_task) {
  ComputationSettings settings;
  settings[Parameter::lambda_limit] = wish.lambda_limit;
  Workbench bench(registry, {.keeps_document = false});
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& angle = bench.get<AngleAxis>();
  if (auto good = bench.need({lambda.id(), angle.id()}); !good) return std::unexpected(good.error());
  bench.choose(settings);
  if (auto good = bench.load(data); !good) return std::unexpected(good.error());
  bench.set_on_task(on_task);
  if (auto good = bench.run_or_throw(job); !good) return std::unexpected(good.error());
  const auto& crust = bench.get<OneStepCrust>();
  CenterLines out =
      center_lines_of(lambda, crust, branches_of(lambda, bench.get<InnerBalls>(), lambda, angle), wish.request, job);
  if (!out.are_ends_joined)
    return no_line(ErrorCode::usage,
                   "the two points are nearest to the same end of the axis, or to ends of two shapes");
  if (out.lines.empty()) {
    const std::string reason = lambda.reason();
    return no_line(ErrorCode::cannot_compute,
                   "there is no centre line: " +
                       (reason.empty() ? "every shape is so compact that its pruned axis is a point" : reason));
  }
  smooth(out, wish.tolerance);
  // Pruned arms reach up to 1 + salience radii; a ray beside them may be somewhat longer.
  if (wish.is_extended) extend_to_curve(out, bench.get<Delaunay>(), crust, 2.0 * (1.0 + wish.request.least_salience));
  return out;
}

}  // namespace mes

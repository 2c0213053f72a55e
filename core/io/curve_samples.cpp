// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/curve_samples.h"

#include <fmt/core.h>
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "core/curves/cuts.h"
#include "core/curves/line_regions.h"
#include "core/curves/resolution.h"
#include "core/document/taken_samples.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

void remove_cuts(CurveSet& curves, const std::function<bool(Vec2)>& on_cut, ReadJob& job) {
  if (curves.resolution == 0.0) {
    double coarsest = 1.0;
    for (const PlaneCurve& curve : curves.curves)
      if (coarsest > 0.0) coarsest = std::min(coarsest, resolution_of(curve.points()));
    curves.resolution = coarsest;
  }
  curves.curves = without_cuts(std::move(curves.curves), curves.resolution, on_cut, job.control());
}

/// Samples curves without cutting them.
Expected<LoadedFile> samples_of(CurveSet curves, const SamplingRequest& wanted, const std::string& name,
                                ReadJob& job) {
  const SamplingRequest request = job.keeps_vertices() ? SamplingRequest{.rule = SamplingRule::vertices} : wanted;
  curves.curves = with_line_regions(std::move(curves.curves), curves.resolution, job.control());
  auto samples = sample(curves, request, {}, job.control());
  if (!samples) return bad_input(samples.error().text, name, 1, 1);
  if (samples->positions.empty()) return bad_input("there is nothing in it to take samples of", name, 1, 1);
  auto data = taken_from(std::make_shared<const CurveSet>(std::move(curves)), *std::move(samples), request);
  if (!data) return bad_input(data.error().text, name, 1, 1);
  LoadedFile file;
  file.data = *std::move(data);
  return file;
}

}  // namespace

Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& wanted, const std::string& name,
                                  ReadJob& job) {
  remove_cuts(
      curves, [](Vec2) { return false; }, job);
  return samples_of(std::move(curves), wanted, name, job);
}

Expected<LoadedFile> load_samples(CurveSet curves, const std::string& name, ReadJob& job,
                                  const std::function<bool(Vec2)>& on_cut, std::size_t added_vertices) {
  remove_cuts(curves, on_cut, job);
  const SamplingRequest request = default_sampling(curves);
  std::size_t vertices = curves.points.size();
  for (const PlaneCurve& curve : curves.curves) vertices += curve.piece_count() + (curve.is_closed() ? 0 : 1);
  vertices -= std::min(vertices, added_vertices);
  auto file = samples_of(std::move(curves), request, name, job);
  if (!file || job.keeps_vertices() || request.rule != SamplingRule::refined) return file;
  const std::size_t samples = file->data.positions.size();
  if (samples <= vertices) return file;
  file->warnings.push_back(Error{
      ErrorCode::bad_input,
      fmt::format("samples were added between the {} vertices, {} in all; the sampling rule \"vertices\" takes the "
                  "vertices alone",
                  vertices, samples),
      name}
                               .message());
  return file;
}

}  // namespace mes

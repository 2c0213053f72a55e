// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/curve_samples.h"

#include <fmt/core.h>
#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/base/geometry/quick_length.h"
#include "core/curves/cuts.h"
#include "core/curves/line_regions.h"
#include "core/curves/resolution.h"
#include "core/document/taken_samples.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

/// Whether an outline follows all its parts twice. Areas are compared first, which is quick.
bool has_no_width(const PlaneCurve& curve, double resolution, ReadJob& job) {
  constexpr double kThin = 1e-4;  // of the square of its size
  if (!curve.is_closed() || !curve.is_polyline()) return false;
  const std::vector<Vec2>& points = curve.points();
  double twice_area = 0.0;
  double size = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    twice_area += cross(points[i - 1] - points[0], points[i] - points[0]);
    size = std::max(size, quick_length(points[i] - points[0]));
  }
  if (!(std::abs(twice_area) <= kThin * size * size)) return false;
  return without_cuts(
             {curve}, resolution, [](Vec2) { return false; }, job.control())
      .empty();
}

/// Returns the number of outlines without a width, which are removed; if nothing remains, that of all outlines.
std::size_t remove_cuts(CurveSet& curves, const std::function<bool(Vec2)>& on_cut, ReadJob& job) {
  if (curves.resolution == 0.0) {
    double coarsest = 1.0;
    for (const PlaneCurve& curve : curves.curves)
      if (coarsest > 0.0) coarsest = std::min(coarsest, resolution_of(curve.points()));
    curves.resolution = coarsest;
  }
  const auto flat = std::ranges::count_if(
      curves.curves, [&](const PlaneCurve& curve) { return has_no_width(curve, curves.resolution, job); });
  const auto all = std::ranges::count_if(curves.curves, &PlaneCurve::is_closed);
  curves.curves = without_cuts(std::move(curves.curves), curves.resolution, on_cut, job.control());
  return static_cast<std::size_t>(curves.is_empty() ? all : flat);
}

/// A sentence on outlines that follow all their parts twice.
std::string about_flat(std::size_t count, bool are_all) {
  if (are_all) return count == 1 ? "its outline has no width" : fmt::format("its {} outlines have no width", count);
  return count == 1 ? "an outline without a width is left out"
                    : fmt::format("{} outlines without a width are left out", count);
}

/// A sentence on a vertex too far away for a document; empty if there is none. Squares of such numbers are infinite, so
/// that sampling would compare all with all.
std::string about_far_vertex(const CurveSet& curves) {
  const auto is_far = [](Vec2 p) {
    return is_finite(p) && std::max(exponent_of(p.x), exponent_of(p.y)) > kMostExponent;
  };
  for (const PlaneCurve& curve : curves.curves) {
    if (!curve.is_polyline()) continue;
    const auto far = std::ranges::find_if(curve.points(), is_far);
    if (far == curve.points().end()) continue;
    std::vector<Vec2> alone{*far};
    return bring_into_range(alone);
  }
  return {};
}

bool holds(const std::set<std::pair<double, double>>& places, Vec2 p) {
  return places.contains({p.x, p.y});
}

/// A line to or from an added vertex becomes a straight quadratic: lines that meet there are chords of one curve, which
/// goes on without a corner, and the others are lines.
void smooth_at(const std::set<std::pair<double, double>>& added, CurveSet& curves) {
  if (added.empty()) return;
  for (PlaneCurve& curve : curves.curves) {
    if (std::ranges::none_of(curve.points(), [&](Vec2 p) { return holds(added, p); })) continue;
    PlaneCurve out(curve.start());
    out.name = curve.name;
    curve.for_each_piece([&](const Piece& piece) {
      if (piece.kind == PieceKind::line && (holds(added, piece.from()) || holds(added, piece.to())))
        out.quadratic_to(0.5 * piece.from() + 0.5 * piece.to(), piece.to());
      else
        out.add(piece);
    });
    if (curve.is_closed()) out.close();
    curve = std::move(out);
  }
}

/// Samples curves without cutting them. `flat` is the number of outlines without a width that were removed.
Expected<LoadedFile> samples_of(CurveSet curves, const SamplingRequest& wanted, const std::string& name, ReadJob& job,
                                std::size_t flat, const MapPlaces& places) {
  if (flat != 0 && curves.is_empty()) return bad_input(about_flat(flat, true), name, 1, 1);
  if (const std::string fault = about_far_vertex(curves); !fault.empty())
    return bad_input("of the samples, " + fault, name, 1, 1);
  const SamplingRequest request = job.takes_vertices() ? SamplingRequest{.rule = SamplingRule::vertices} : wanted;
  curves.curves = with_line_regions(std::move(curves.curves), curves.resolution, job.control());
  auto samples = sample(curves, request, {}, job.control());
  if (!samples) return bad_input(samples.error().text, name, 1, 1);
  if (samples->positions.empty()) return bad_input("there is nothing in it to take samples of", name, 1, 1);
  smooth_at(places.added, curves);
  auto data = taken_from(std::make_shared<const CurveSet>(std::move(curves)), *std::move(samples), request);
  if (!data) return bad_input(data.error().text, name, 1, 1);
  LoadedFile file;
  file.data = *std::move(data);
  if (flat != 0) file.warnings.push_back(Error{ErrorCode::bad_input, about_flat(flat, false), name}.message());
  return file;
}

}  // namespace

Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& wanted, const std::string& name,
                                  ReadJob& job) {
  const std::size_t flat = remove_cuts(
      curves, [](Vec2) { return false; }, job);
  return samples_of(std::move(curves), wanted, name, job, flat, {});
}

Expected<LoadedFile> load_samples(CurveSet curves, const std::string& name, ReadJob& job, const MapPlaces& places) {
  const std::size_t flat = remove_cuts(
      curves, [&](Vec2 p) { return holds(places.on_cut, p); }, job);
  const SamplingRequest request = default_sampling(curves);
  std::size_t vertices = curves.points.size();
  for (const PlaneCurve& curve : curves.curves) vertices += curve.piece_count() + (curve.is_closed() ? 0 : 1);
  vertices -= std::min(vertices, places.added.size());
  auto file = samples_of(std::move(curves), request, name, job, flat, places);
  if (!file || job.takes_vertices() || request.rule != SamplingRule::refined) return file;
  const std::size_t samples = file->data.positions.size();
  if (samples <= vertices) return file;
  file->has_added_samples = true;
  file->warnings.push_back(
      Error{ErrorCode::bad_input,
            fmt::format("samples were added between the {}vertices, {} in all",
                        vertices == 0 ? std::string() : grouped(vertices) + ' ', grouped(samples)),
            name}
          .message());
  return file;
}

}  // namespace mes

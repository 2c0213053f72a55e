// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/library/internal/adapter.h"
#include "core/shapes/shape.h"

namespace mesecina {
inline namespace v1 {
namespace {

double accepted(const mes::Parameter& parameter, double value) {
  const bool is_in_range = value >= parameter.low && value <= parameter.high;
  if (is_in_range && (!parameter.is_whole || value == std::floor(value))) return value;
  refuse(fmt::format("parameter {} expects a {} from {} to {}, not {}", parameter.id,
                     parameter.is_whole ? "whole number" : "number", parameter.low, parameter.high, value));
}

mes::ShapeRequest inner(const mes::ShapeDescriptor& shape, const ShapeRequest& request) {
  mes::ShapeRequest out{.values = mes::values_of(shape)};
  for (const auto& [id, value] : request.parameters) {
    const auto found = std::ranges::find(shape.parameters, id, &mes::Parameter::id);
    if (found == shape.parameters.end()) refuse_unknown(fmt::format("parameter of {}", shape.id), id);
    out.values.numbers[*found] = accepted(*found, value);
  }
  for (const auto& [id, text] : request.formulas) {
    const auto found = std::ranges::find(shape.formulas, id, &mes::FormulaParameter::id);
    if (found == shape.formulas.end()) refuse_unknown(fmt::format("formula of {}", shape.id), id);
    out.values.formulas[static_cast<std::size_t>(found - shape.formulas.begin())] = text;
  }
  out.sampling = {
      .samples = request.samples, .spacing = request.spacing, .jitter = request.jitter, .seed = request.seed};
  return out;
}

}  // namespace

mes::SampleData inner(const Data& data) {
  mes::SampleData out{.positions = all_inner(data.samples), .balls = all_inner(data.balls)};
  for (const Contour& contour : data.contours) out.contours.push_back({contour.is_closed, contour.points});
  return out;
}

Data outer(const mes::SampleData& data) {
  Data out{.samples = all_outer(data.positions), .balls = all_outer(data.balls)};
  for (const mes::SampleData::Contour& contour : data.contours)
    out.contours.push_back({contour.closed, contour.points});
  return out;
}

Data make_shape(const Catalogue& catalogue, std::string_view shape, const ShapeRequest& request) {
  Job job;
  return make_shape(catalogue, shape, request, job);
}

Data make_shape(const Catalogue& catalogue, std::string_view shape, const ShapeRequest& request, Job& job) {
  return guarded([&] {
    JobAccess::control(job).checkpoint();
    const auto known = CatalogueAccess::registry(catalogue)->shapes().find(shape);
    if (!known) refuse_unknown("shape", shape);
    return outer(taken(mes::make_shape(*known, inner(*known, request), &JobAccess::control(job))));
  });
}

}  // namespace v1
}  // namespace mesecina

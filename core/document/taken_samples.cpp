// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/taken_samples.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/coordinate_range.h"

namespace mes {
namespace {

bool is_finite(const PlaneCurve& curve) {
  return std::ranges::all_of(curve.points(), [](Vec2 p) { return mes::is_finite(p); }) &&
         std::ranges::all_of(curve.arcs(), [](const EllipticArc& arc) {
           return mes::is_finite(arc.center) && mes::is_finite(arc.u) && mes::is_finite(arc.v) &&
                  mes::is_finite(Vec2{arc.start, arc.sweep});
         });
}

}  // namespace

std::string bring_into_range(std::vector<Vec2>& positions) {
  int most = Magnitudes{}.most;
  for (const Vec2 p : positions)
    for (const double x : {p.x, p.y})
      if (x != 0.0) most = std::max(most, exponent_of(x));
  for (Vec2& p : positions)
    for (double* x : {&p.x, &p.y}) {
      *x = without_traces(*x, most);
      if (const auto fault = range_fault_of(*x)) return describe(*fault, *x);
    }
  return {};
}

Expected<SampleData> taken_from(std::shared_ptr<const CurveSet> curves, SampledCurves samples,
                                const SamplingRequest& request) {
  if (std::string fault = bring_into_range(samples.positions); !fault.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "of the samples, " + fault});
  SampleData out;
  out.contours.reserve(samples.chains.size());
  for (const SampledCurves::Chain& chain : samples.chains) {
    SampleData::Contour& contour = out.contours.emplace_back(SampleData::Contour{chain.is_closed, {}});
    contour.points.reserve(chain.count);
    for (std::size_t i = 0; i < chain.count; ++i)
      contour.points.push_back(static_cast<std::uint32_t>(chain.first + i));
  }
  out.positions = std::move(samples.positions);
  if (std::ranges::all_of(curves->curves, [](const PlaneCurve& curve) { return is_finite(curve); })) {
    const auto count = static_cast<std::uint32_t>(out.positions.size());
    out.source = std::make_shared<const CurveSource>(CurveSource{std::move(curves), request, 0, count});
  }
  return out;
}

}  // namespace mes

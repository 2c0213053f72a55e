// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/taken_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/geometry/coordinate_range.h"

namespace mes {
namespace {

// Magnitudes are ordered like their bits.
std::uint64_t magnitude_bits(double x) {
  constexpr std::uint64_t kMagnitude = ~std::uint64_t{0} >> 1U;
  return std::bit_cast<std::uint64_t>(x) & kMagnitude;
}

bool is_finite(const PlaneCurve& curve) {
  std::uint64_t largest = 0;
  for (const Vec2 p : curve.points()) largest = std::max({largest, magnitude_bits(p.x), magnitude_bits(p.y)});
  return std::isfinite(std::bit_cast<double>(largest)) &&
         std::ranges::all_of(curve.arcs(), [](const EllipticArc& arc) {
           return mes::is_finite(arc.center) && mes::is_finite(arc.u) && mes::is_finite(arc.v) &&
                  mes::is_finite(Vec2{arc.start, arc.sweep});
         });
}

}  // namespace

std::string bring_into_range(std::vector<Vec2>& positions) {
  // Subtracting 1 from the bits makes zeros the largest. Negative zeros must change too, like rounding noise.
  constexpr std::uint64_t kNegativeZero = std::uint64_t{1} << 63U;
  struct Extent {
    std::uint64_t largest = 0;
    std::uint64_t least = ~std::uint64_t{0};
    bool may_stay = true;
    void add(double x) {
      largest = std::max(largest, magnitude_bits(x));
      least = std::min(least, magnitude_bits(x) - 1);
      may_stay &= std::bit_cast<std::uint64_t>(x) != kNegativeZero;
    }
  };
  Extent across;
  Extent along;  // separate from `across`, so that the two do not wait for each other
  for (const Vec2 p : positions) {
    across.add(p.x);
    along.add(p.y);
  }
  const std::uint64_t largest = std::max(across.largest, along.largest);
  const std::uint64_t least = std::min(across.least, along.least);
  bool may_stay = across.may_stay && along.may_stay;
  const int most = exponent_of(std::bit_cast<double>(largest));
  const double smallest = std::bit_cast<double>(least + 1);
  may_stay =
      may_stay && !range_fault_of(std::bit_cast<double>(largest)) && without_traces(smallest, most) == smallest;
  if (may_stay) return {};
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
    contour.points.resize(chain.count);
    if (samples.order.empty())
      std::iota(contour.points.begin(), contour.points.end(), static_cast<std::uint32_t>(chain.first));
    else
      std::copy_n(samples.order.begin() + static_cast<std::ptrdiff_t>(chain.first), chain.count,
                  contour.points.begin());
  }
  out.positions = std::move(samples.positions);
  // A polyline has no numbers other than its vertices, which are finite if they are samples.
  const auto has_finite_samples = [&](const PlaneCurve& curve) {
    return request.rule == SamplingRule::vertices && request.corner_radius == 0.0 && curve.is_polyline();
  };
  if (std::ranges::all_of(curves->curves,
                          [&](const PlaneCurve& curve) { return has_finite_samples(curve) || is_finite(curve); })) {
    const auto count = static_cast<std::uint32_t>(out.positions.size());
    out.source = std::make_shared<const CurveSource>(CurveSource{std::move(curves), request, 0, count});
  }
  return out;
}

}  // namespace mes

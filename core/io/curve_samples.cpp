// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/curve_samples.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/coordinate_range.h"
#include "core/io/text_numbers.h"

namespace mes {
namespace {

/// Nothing, or why some coordinate is out of range.
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

}  // namespace

Expected<LoadedFile> load_samples(const CurveSet& curves, const SamplingRequest& request, const std::string& name) {
  auto samples = sample(curves, request);
  if (!samples) return bad_input(samples.error().text, name, 1, 1);
  if (samples->positions.empty()) return bad_input("there is nothing in it to take samples of", name, 1, 1);
  if (std::string fault = bring_into_range(samples->positions); !fault.empty())
    return bad_input("of the samples, " + fault, name, 1, 1);

  LoadedFile file;
  file.data.contours.reserve(samples->chains.size());
  for (const SampledCurves::Chain& chain : samples->chains) {
    SampleData::Contour& contour = file.data.contours.emplace_back(SampleData::Contour{chain.is_closed, {}});
    contour.points.reserve(chain.count);
    for (std::size_t i = 0; i < chain.count; ++i)
      contour.points.push_back(static_cast<std::uint32_t>(chain.first + i));
  }
  file.data.positions = std::move(samples->positions);
  return file;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/geometry/sampling_epsilon.h"

#include <fmt/core.h>
#include <cmath>
#include <utility>

#include "core/base/counted.h"

namespace mes {

std::string SamplingEpsilon::text() const {
  std::string out = is_estimate ? "estimated epsilon " : "epsilon ";
  if (std::isfinite(value)) {
    const double scale = value > 0.0 ? std::pow(10.0, 2.0 - std::floor(std::log10(value))) : 1.0;
    out += fmt::format("{:.3g}", std::ceil(value * scale * (1.0 - 1e-12)) / scale);
  } else {
    out += "infinite";
  }
  std::string exempt;
  for (const auto& [count, one] : {std::pair{corners, "corner"}, {ends, "end"}, {junctions, "junction"}})
    if (count != 0) exempt += (exempt.empty() ? "" : ", ") + counted(count, one);
  return exempt.empty() ? out : out + " (" + exempt + " exempt)";
}

}  // namespace mes

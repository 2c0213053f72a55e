// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/geometry/sampling_epsilon.h"

#include <fmt/core.h>
#include <cmath>

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
  if (corners + ends == 0) return out;
  out += " (";
  if (corners != 0) out += counted(corners, "corner");
  if (corners != 0 && ends != 0) out += ", ";
  if (ends != 0) out += counted(ends, "end");
  return out + " exempt)";
}

}  // namespace mes

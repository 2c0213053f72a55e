// SPDX-License-Identifier: GPL-3.0-or-later
// The epsilon of samples, in the words that are used wherever one is given.
#pragma once

#include <cstddef>
#include <string>

namespace mes {

/// Samples are an epsilon-sample if each point of the curve has one within epsilon times its local feature size. No
/// density satisfies that at a corner, nor at an end or a junction of the curve as samples show it. These points are
/// exempt, and their number belongs to every epsilon that is given.
struct SamplingEpsilon {
  double value = 0.0;         ///< may be infinite: a part of the curves has no sample
  std::size_t corners = 0;    ///< exempt corners and meetings of curves
  std::size_t ends = 0;       ///< exempt ends of the crust
  std::size_t junctions = 0;  ///< exempt samples at which three or more edges of the crust meet
  bool is_estimate = false;   ///< the samples are the only evidence of curve and axis

  /// "epsilon 0.241 (2 corners exempt)", "estimated epsilon 0.25 (1 corner, 3 ends exempt)"; rounded up, because it
  /// states a bound.
  std::string text() const;
  friend bool operator==(const SamplingEpsilon&, const SamplingEpsilon&) = default;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/sampling/ball_halving.h"

#include <fmt/core.h>

#include "core/graph/size_refusal.h"

namespace mes {

std::optional<double> wider_tolerance(const BallHalving& halving, double diameter) {
  if (!halving.has_use_for_tolerance()) return std::nullopt;
  const double tolerance = halving.tolerance();
  const double largest = std::ldexp(diameter, -11);
  const double next = tolerance == 0.0 ? std::ldexp(diameter, -29) : 4.0 * tolerance;
  if (std::isnormal(next) && next <= largest) return next;
  return std::nullopt;
}

double next_tolerance(const BallHalving& halving, double diameter) {
  if (const auto next = wider_tolerance(halving, diameter)) return *next;
  throw SizeRefusal(fmt::format(
      "it takes more than {} balls along the axis; a smaller medial-sampling-angle takes fewer, and below 1 "
      "a larger scale-axis-factor",
      kMostBallsBetween));
}

void find_tolerance(std::string_view structure, double tolerance, std::size_t balls, std::vector<Finding>& out) {
  if (tolerance == 0.0) return;
  out.push_back(
      {FindingLevel::note,
       fmt::format("{}: sampled balls, some of them farther apart than medial-sampling-angle asks for, which "
                   "would take more than {}; dents between those are at most {:.2g} deep",
                   structure, kMostBallsBetween, tolerance),
       static_cast<std::int64_t>(balls),
       {},
       {}});
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Additive growth: balls of radius r get the radius sqrt(r^2 + alpha-radius^2), and alpha-radius changes step by step.
// So power cells do not change, and the dual complexes of the grown balls are nested alpha complexes.
#include <cmath>

#include "core/evolutions/evolution.h"

namespace mes {
namespace {

const Parameter kAlphaStep{.id = "alpha-step",
                           .explanation = "Amount that a step adds to alpha-radius or subtracts",
                           .unit = "units",
                           .low = 0.0,
                           .high = 1e150,
                           .default_value = 1.0,
                           .is_length = true,
                           .title = "Step"};

double by_steps(double first, double sign, std::uint64_t k, const ParameterValues& values) {
  // A remainder that only comes from the rounding of k steps counts as zero.
  const double way = static_cast<double>(k) * values[kAlphaStep];
  const double out = first + sign * way;
  return std::abs(out) <= 0x1p-40 * first ? 0.0 : out;
}
double grown_radius(double first, std::uint64_t k, const ParameterValues& values) {
  return by_steps(first, 1.0, k, values);
}
double shrunk_radius(double first, std::uint64_t k, const ParameterValues& values) {
  return by_steps(first, -1.0, k, values);
}

}  // namespace

Evolution alpha_growing_evolution() {
  return {{"alpha-growing",
           "Additive growth: grow",
           "Disks around the samples grow, and balls to sqrt(r^2 + alpha-radius^2), with nested alpha complexes",
           false,
           {kAlphaStep},
           "disks grown additively"},
          ParameterMove{Parameter::alpha_radius, grown_radius}};
}
Evolution alpha_shrinking_evolution() {
  return {{"alpha-shrinking",
           "Additive growth: shrink",
           "Disks and balls grown by alpha-radius shrink back, to points and to the original balls",
           false,
           {kAlphaStep},
           "disks grown additively"},
          ParameterMove{Parameter::alpha_radius, shrunk_radius}};
}

}  // namespace mes

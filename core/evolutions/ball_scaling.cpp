// SPDX-License-Identifier: GPL-3.0-or-later
// Growing and shrinking: scales the balls of a family, or those along an axis, about their centres, step by step.
#include "core/evolutions/evolution.h"

namespace mes {
namespace {

const Parameter kGrowingStep{
    .id = "growing-step",
    .explanation = "Increase per step of the factor that radii are multiplied or divided by",
    .unit = "%",
    .low = 0.01,
    .high = 100.0,
    .default_value = 3.0,
    .title = "Step",
    .window_explanation = "Increase per step of the factor by which radii are multiplied or divided"};

double factor(std::uint64_t k, const ParameterValues& values) {
  return 1.0 + static_cast<double>(k) * (values[kGrowingStep] / 100.0);
}
double grown_scale(double first, std::uint64_t k, const ParameterValues& values) {
  return first * factor(k, values);
}
double shrunk_scale(double first, std::uint64_t k, const ParameterValues& values) {
  return first / factor(k, values);
}

Evolution growing(const char* id, const char* name, const char* tooltip, const char* balls, const Parameter& scale) {
  return {{id, name, tooltip, false, {kGrowingStep}, balls}, ParameterMove{scale, grown_scale}};
}
Evolution shrinking(const char* id, const char* name, const char* tooltip, const char* balls,
                    const Parameter& scale) {
  return {{id, name, tooltip, false, {kGrowingStep}, balls}, ParameterMove{scale, shrunk_scale}};
}

constexpr const char* kInner = "the inner balls";
constexpr const char* kPolar = "the polar balls";
constexpr const char* kOwn = "your own balls";
constexpr const char* kAlongAxis = "the balls along the axis";

}  // namespace

Evolution a_growing_evolution() {
  return growing("a-growing", "Inner balls: grow", "The inner Voronoi balls grow, and their union with them", kInner,
                 Parameter::a_scale);
}
Evolution a_shrinking_evolution() {
  return shrinking("a-shrinking", "Inner balls: shrink", "The inner Voronoi balls shrink, and their union with them",
                   kInner, Parameter::a_scale);
}
Evolution p_growing_evolution() {
  return growing("p-growing", "Polar balls: grow", "The inner polar balls grow, and their union with them", kPolar,
                 Parameter::p_scale);
}
Evolution p_shrinking_evolution() {
  return shrinking("p-shrinking", "Polar balls: shrink", "The inner polar balls shrink, and their union with them",
                   kPolar, Parameter::p_scale);
}
Evolution b_growing_evolution() {
  return growing("b-growing", "Own balls: grow", "Your own balls grow, and their union with them", kOwn,
                 Parameter::b_scale);
}
Evolution b_shrinking_evolution() {
  return shrinking("b-shrinking", "Own balls: shrink", "Your own balls shrink, and their union with them", kOwn,
                   Parameter::b_scale);
}

Evolution scale_axis_growing_evolution() {
  return growing("scale-axis-growing", "Balls along the axis: grow",
                 "Balls sampled along the medial axis grow, and the scale axis of their union with them", kAlongAxis,
                 Parameter::scale_axis_factor);
}
Evolution scale_axis_shrinking_evolution() {
  return shrinking("scale-axis-shrinking", "Balls along the axis: shrink",
                   "Balls sampled along the medial axis shrink, and the scale axis of their union with them",
                   kAlongAxis, Parameter::scale_axis_factor);
}

Evolution scale_skeleton_evolution() {
  Evolution out = growing("scale-skeleton", "Balls along the axis: simplify",
                          "Balls sampled along the medial axis grow, and those along the scale axis replace them "
                          "after each scale-skeleton-step",
                          kAlongAxis, Parameter::scale_axis_factor);
  std::get<ParameterMove>(out.move).renews_balls = true;
  return out;
}

}  // namespace mes

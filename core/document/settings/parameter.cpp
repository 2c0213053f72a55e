// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/settings/parameter.h"

#include <algorithm>
#include <cmath>

namespace mes {

const Parameter Parameter::union_shortcut{
    .id = "union-shortcut",
    .explanation =
        "1: unions of inner and polar balls are exact even in fast, and are computed in a shorter way where that is "
        "certified; 0: they are computed by the general pipeline in the number type",
    .default_value = 1.0,
    .is_whole = true,
    .title = "Certified shortcut for unions"};
const Parameter Parameter::pole_propagation{
    .id = "pole-propagation",
    .explanation =
        "0: a pole is inside if its triangle is; 1: labels spread from pole to pole, as Amenta, Choi and Kolluri do",
    .is_whole = true,
    .title = "Pole labels by propagation"};
const Parameter Parameter::medial_sampling_angle{
    .id = "medial-sampling-angle",
    .explanation =
        "Sampled balls are added until neighbouring circles cross at this angle or more; nearer to 180 is denser",
    .unit = "degrees",
    .low = 90.0,
    .high = 179.9,
    .default_value = 175.0,
    .title = "Angle of sampled balls"};
const Parameter Parameter::a_scale{
    .id = "a-scale",
    .explanation =
        "Exact factor by which the radii of the inner Voronoi balls are multiplied before their union is taken",
    .low = 0.01,
    .high = 100.0,
    .default_value = 1.0,
    .is_of_document = true,
    .is_multiplier = true,
    .title = "Inner balls: scale"};
const Parameter Parameter::p_scale{
    .id = "p-scale",
    .explanation =
        "Exact factor by which the radii of the inner polar balls are multiplied before their union is taken",
    .low = 0.01,
    .high = 100.0,
    .default_value = 1.0,
    .is_of_document = true,
    .is_multiplier = true,
    .title = "Polar balls: scale"};
const Parameter Parameter::b_scale{
    .id = "b-scale",
    .explanation = "Exact factor by which the radii of your own balls are multiplied before their union is taken",
    .low = 0.01,
    .high = 100.0,
    .default_value = 1.0,
    .is_of_document = true,
    .is_multiplier = true,
    .title = "Own balls: scale"};
const Parameter Parameter::lambda_limit{
    .id = "lambda-limit",
    .explanation =
        "The lambda axis keeps points whose nearest samples need an enclosing circle of at least this radius",
    .unit = "units",
    .low = 0.0,
    .high = 1e150,
    .is_of_document = true,
    .is_limit = true,
    .is_length = true,
    .title = "Lambda: limit"};
const Parameter Parameter::angle_limit{
    .id = "angle-limit",
    .explanation = "The angle axis keeps points where half the angle between the nearest samples is at least this",
    .unit = "degrees",
    .low = 0.0,
    .high = 90.0,
    .is_of_document = true,
    .is_limit = true,
    .title = "Object angle: limit"};
const Parameter Parameter::angle_mode{
    .id = "angle-mode",
    .explanation =
        "0: the angle axis is cut at the points where the angle reaches the limit; 1: whole edges, by their largest "
        "angle; 2: by the mean of the angles at their ends",
    .unit = "",
    .low = 0.0,
    .high = 2.0,
    .is_whole = true,
    .title = "Object angle of an edge",
    .window_explanation = "Which angle decides for an axis edge, along which it varies",
    .choices = {"Each point by its own angle", "Edges by their largest angle", "Edges by the mean of their ends"}};
const Parameter Parameter::keep_topology{
    .id = "keep-topology",
    .explanation =
        "1: the lambda and the angle axis are pruned from their free ends inwards, so that components and cycles "
        "stay; 0: all parts below the limit are removed",
    .unit = "",
    .low = 0.0,
    .high = 1.0,
    .is_whole = true,
    .title = "Filters keep the topology"};
const Parameter Parameter::scale_axis_factor{
    .id = "scale-axis-factor",
    .explanation =
        "Factor by which the balls along the medial axis grow, or shrink below 1, before the scale axis of their "
        "union is taken; 1: the axis itself",
    .unit = "",
    .low = 0.1,
    .high = 3.0,
    .default_value = 1.0,
    .is_of_document = true,
    .is_limit = true,
    .title = "Scale axis: factor"};
const Parameter Parameter::scale_skeleton_step{.id = "scale-skeleton-step",
                                               .explanation =
                                                   "The scale skeleton reaches scale-axis-factor in steps of this "
                                                   "size, and samples the balls along its axis again after each",
                                               .unit = "%",
                                               .low = 1.0,
                                               .high = 100.0,
                                               .default_value = 3.0,
                                               .title = "Scale skeleton: step"};
const Parameter Parameter::alpha_radius{
    .id = "alpha-radius",
    .explanation =
        "Radius of the disks around the samples in the alpha complex; balls of a family grow from radius r to "
        "sqrt(r^2 + alpha-radius^2)",
    .unit = "units",
    .low = 0.0,
    .high = 1e150,
    .is_of_document = true,
    .is_limit = true,
    .is_length = true,
    .title = "Alpha complex: radius",
    .window_explanation =
        "Radius of the disks about the samples. Balls grow with it: one of radius r has the radius sqrt(r^2 + "
        "alpha-radius^2)"};

const Parameter Parameter::center_line_pruning{
    .id = "center-line-pruning",
    .explanation =
        "Centre lines ignore branches of the axis that reach beyond the ball at their junction by less than this "
        "part "
        "of its radius; 0.5 ignores those into corners of 84 degrees and more, 0 none",
    .low = 0.0,
    .high = 10.0,
    .default_value = 0.5,
    .is_limit = true,
    .title = "Centre lines: pruning"};
const Parameter Parameter::center_line_branches{
    .id = "center-line-branches",
    .explanation = "Largest number of centre lines in a shape; the longest come first",
    .low = 1.0,
    .high = 1000.0,
    .default_value = 1.0,
    .is_whole = true,
    .is_limit = true,
    .title = "Centre lines: lines of a shape"};
const Parameter Parameter::transects{
    .id = "transects",
    .explanation = "Number of transects across all centre lines together, in equal steps along them",
    .low = 1.0,
    .high = 10'000.0,
    .default_value = 100.0,
    .is_whole = true,
    .is_limit = true,
    .title = "Transects: number"};

std::span<const Parameter> computation_parameters() {
  static const std::vector<Parameter> all{Parameter::union_shortcut,
                                          Parameter::pole_propagation,
                                          Parameter::medial_sampling_angle,
                                          Parameter::a_scale,
                                          Parameter::p_scale,
                                          Parameter::b_scale,
                                          Parameter::lambda_limit,
                                          Parameter::angle_limit,
                                          Parameter::angle_mode,
                                          Parameter::keep_topology,
                                          Parameter::scale_axis_factor,
                                          Parameter::scale_skeleton_step,
                                          Parameter::alpha_radius,
                                          Parameter::center_line_pruning,
                                          Parameter::center_line_branches,
                                          Parameter::transects};
  return all;
}

double within(const Parameter& parameter, double value) {
  const double near = std::clamp(value, parameter.low, parameter.high);
  return parameter.is_whole ? std::round(near) : near;
}

}  // namespace mes

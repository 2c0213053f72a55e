// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that steer structures and layers, as everybody may know them: the command line, the window, the manual.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace mes {

/// Position in `parameter_descriptors()`.
enum class Parameter : std::uint8_t {
  union_shortcut,
  pole_propagation,
  medial_sampling_angle,
  a_scale,
  p_scale,
  b_scale,
  lambda_limit,
  angle_limit,
  angle_mode,
  keep_topology,
  scale_axis_factor,
  scale_skeleton_step,
  alpha_radius
};
inline constexpr std::size_t kParameters = 13;

struct ParameterDescriptor {
  std::string_view id;           ///< public name, kebab case
  std::string_view explanation;  ///< one sentence, no full stop
  std::string_view unit{};       ///< empty = a plain number
  double low = 0.0;
  double high = 1.0;
  double default_value = 0.0;
  bool is_whole = false;        ///< whole numbers only
  bool is_of_document = false;  ///< another document begins with the default; else it is the user's and stays
  bool is_limit = false;        ///< of a filter: what lies beyond the range is taken to its end, not refused
  bool is_length = false;       ///< in units of the document; `high` is too large for the end of a slider
  bool is_multiplier = false;   ///< lengths are multiplied by it
  std::string_view title{};     ///< as the window calls it; empty: the id in words
  /// The explanation where the window shows no number, or has other words; empty: as everywhere.
  std::string_view window_explanation{};
  std::span<const std::string_view> choices{};  ///< what its whole numbers stand for, from `low`; empty: numbers
};

inline constexpr std::array<std::string_view, 3> kAngleModes{
    "Each point by its own angle", "Edges by their largest angle", "Edges by the mean of their ends"};

inline constexpr std::array<ParameterDescriptor, kParameters> kParameterDescriptors{
    {{.id = "union-shortcut",
      .explanation =
          "1: unions of balls of samples are exact in fast, too, and follow from shared samples where that is "
          "certified; 0: the general pipeline in the number type",
      .default_value = 1.0,
      .is_whole = true,
      .title = "Certified shortcut for unions"},
     {.id = "pole-propagation",
      .explanation = "0: a pole is inside where its triangle is; 1: labels spread from pole to pole, as Amenta, Choi "
                     "and Kolluri do",
      .is_whole = true,
      .title = "Pole labels by propagation"},
     {.id = "medial-sampling-angle",
      .explanation =
          "Sampled balls are added until neighbouring circles cross at this angle or more; nearer to 180 is denser",
      .unit = "degrees",
      .low = 90.0,
      .high = 179.9,
      .default_value = 175.0,
      .title = "Angle of sampled balls"},
     {.id = "a-scale",
      .explanation =
          "The radii of the inner Voronoi balls are multiplied by it, exactly, before their union is taken",
      .low = 0.01,
      .high = 100.0,
      .default_value = 1.0,
      .is_of_document = true,
      .is_multiplier = true,
      .title = "Inner balls: scale"},
     {.id = "p-scale",
      .explanation = "The radii of the inner polar balls are multiplied by it, exactly, before their union is taken",
      .low = 0.01,
      .high = 100.0,
      .default_value = 1.0,
      .is_of_document = true,
      .is_multiplier = true,
      .title = "Polar balls: scale"},
     {.id = "b-scale",
      .explanation = "The radii of your own balls are multiplied by it, exactly, before their union is taken",
      .low = 0.01,
      .high = 100.0,
      .default_value = 1.0,
      .is_of_document = true,
      .is_multiplier = true,
      .title = "Own balls: scale"},
     {.id = "lambda-limit",
      .explanation =
          "The lambda axis is where the smallest circle around the nearest samples has at least this radius",
      .unit = "units",
      .low = 0.0,
      .high = 1e150,
      .is_of_document = true,
      .is_limit = true,
      .is_length = true,
      .title = "Lambda: limit"},
     {.id = "angle-limit",
      .explanation = "The angle axis is where half the angle between the nearest samples is at least this",
      .unit = "degrees",
      .low = 0.0,
      .high = 90.0,
      .is_of_document = true,
      .is_limit = true,
      .title = "Object angle: limit"},
     {.id = "angle-mode",
      .explanation = "0: the angle axis is cut at the places where the angle reaches the limit; 1: whole edges, by "
                     "their largest angle; 2: by the mean of the angles at their ends",
      .unit = "",
      .low = 0.0,
      .high = 2.0,
      .is_whole = true,
      .title = "Object angle of an edge",
      .window_explanation = "What stands for an axis edge, along which the angle varies",
      .choices = kAngleModes},
     {.id = "keep-topology",
      .explanation =
          "1: the lambda and the angle axis are pruned from their free ends inwards, so that components and "
          "cycles stay; 0: all that is below the limit goes",
      .unit = "",
      .low = 0.0,
      .high = 1.0,
      .is_whole = true,
      .title = "Filters keep the topology"},
     {.id = "scale-axis-factor",
      .explanation =
          "The balls along the medial axis are grown by it, below 1 shrunk, before the scale axis is taken "
          "of their union; 1: the axis itself",
      .unit = "",
      .low = 0.1,
      .high = 3.0,
      .default_value = 1.0,
      .is_of_document = true,
      .is_limit = true,
      .title = "Scale axis: factor"},
     {.id = "scale-skeleton-step",
      .explanation =
          "The scale skeleton reaches scale-axis-factor in steps of this size, and takes the balls along its "
          "axis anew after each",
      .unit = "%",
      .low = 1.0,
      .high = 100.0,
      .default_value = 3.0,
      .title = "Scale skeleton: step"},
     {.id = "alpha-radius",
      .explanation =
          "The alpha complex is that of disks of this radius about the samples; balls of a family grow from "
          "radius r to the root of r^2 and its square",
      .unit = "units",
      .low = 0.0,
      .high = 1e150,
      .is_of_document = true,
      .is_limit = true,
      .is_length = true,
      .title = "Alpha complex: radius",
      .window_explanation =
          "Radius of the disks about the samples. Balls grow with it: one of radius r has the radius sqrt(r^2 + "
          "alpha-radius^2)"}}};
static_assert(!kParameterDescriptors.back().id.empty(), "as many as there are names for");

constexpr bool is_switch(const ParameterDescriptor& descriptor) {
  return descriptor.is_whole && descriptor.low == 0.0 && descriptor.high == 1.0;
}

/// Every parameter.
constexpr std::span<const ParameterDescriptor> parameter_descriptors() {
  return kParameterDescriptors;
}

constexpr const ParameterDescriptor& descriptor_of(Parameter parameter) {
  return parameter_descriptors()[static_cast<std::size_t>(parameter)];
}

}  // namespace mes

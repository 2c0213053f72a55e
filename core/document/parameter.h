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
  b_scale
};
inline constexpr std::size_t kParameters = 6;

struct ParameterDescriptor {
  std::string_view id;           ///< public name, kebab case
  std::string_view explanation;  ///< one sentence, no full stop
  std::string_view unit;         ///< empty = a plain number
  double low = 0.0;
  double high = 1.0;
  double default_value = 0.0;
  bool is_whole = false;        ///< whole numbers only
  bool is_of_document = false;  ///< another document begins with the default; else it is the user's and stays
};

inline constexpr std::array<ParameterDescriptor, kParameters> kParameterDescriptors{
    {{"union-shortcut",
      "1: unions of balls of samples are exact in fast, too, and follow from shared samples where that is certified; "
      "0: the general pipeline in the number type",
      "", 0.0, 1.0, 1.0, true},
     {"pole-propagation",
      "0: a pole is inside where its triangle is; 1: labels spread from pole to pole, as Amenta, Choi and Kolluri do",
      "", 0.0, 1.0, 0.0, true},
     {"medial-sampling-angle",
      "Sampled balls are added until neighbouring circles cross at this angle or more; nearer to 180 is denser",
      "degrees", 90.0, 179.9, 175.0},
     {"a-scale", "The radii of the inner Voronoi balls are multiplied by it, exactly, before their union is taken",
      "", 0.01, 100.0, 1.0, false, true},
     {"p-scale", "The radii of the inner polar balls are multiplied by it, exactly, before their union is taken", "",
      0.01, 100.0, 1.0, false, true},
     {"b-scale", "The radii of your own balls are multiplied by it, exactly, before their union is taken", "", 0.01,
      100.0, 1.0, false, true}}};

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

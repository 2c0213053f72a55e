// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that steer structures and layers, as everybody may know them: the command line, the window, the manual.
#pragma once

#include <span>
#include <string_view>

namespace mes {

struct ParameterDescriptor {
  std::string_view id;           ///< public name, kebab case
  std::string_view explanation;  ///< one sentence, no full stop
  std::string_view unit;         ///< empty = a plain number
  double low = 0.0;
  double high = 1.0;
  double default_value = 0.0;
};

/// Every parameter. The one-step pipeline has none: the sample alone decides what it shows.
constexpr std::span<const ParameterDescriptor> parameter_descriptors() {
  return {};
}

}  // namespace mes

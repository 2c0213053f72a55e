// SPDX-License-Identifier: GPL-3.0-or-later
// Lists parameters that are not at their defaults, so that no picture depends on a number that is not on screen.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/document/settings/computation_settings.h"

namespace mes {

struct ChangedParameter {
  Parameter parameter{};
  std::string text{};  ///< "Inner balls: scale 2.14 ×", "Union shortcut off"
};

/// Parameters of the document come first, the others in the given order.
std::vector<ChangedParameter> changed_parameters(std::span<const Parameter> parameters,
                                                 const ComputationSettings& settings);

/// The value with its unit: "2.14 ×", "150°", "on".
std::string value_text(const Parameter& descriptor, double value);

/// The number of items of these widths, from the first and with `gap` between them, that fit into `room`. If not all
/// fit, there is also room after them for one more of width `rest`, as long as `room` is not smaller than that.
std::size_t how_many_fit(std::span<const float> widths, float gap, float rest, float room);

}  // namespace mes

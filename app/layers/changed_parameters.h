// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that are not at their defaults, in words, so that no picture depends on a number that is not on screen.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/document/computation_settings.h"

namespace mes {

struct ChangedParameter {
  Parameter parameter{};
  std::string text{};  ///< "Inner balls: scale 2.14 ×", "Union shortcut off"
};

/// Those of the document first, else in the order in which the parameters are given.
std::vector<ChangedParameter> changed_parameters(std::span<const Parameter> parameters,
                                                 const ComputationSettings& settings);

/// "2.14 ×", "150°", "on".
std::string value_text(const Parameter& descriptor, double value);

/// How many things of these widths, from the first and with `gap` between them, fit into `room`. If not all do, there
/// is room for one more of the width `rest` after them, as long as `room` is not smaller than that.
std::size_t how_many_fit(std::span<const float> widths, float gap, float rest, float room);

}  // namespace mes

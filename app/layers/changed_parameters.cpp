// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/changed_parameters.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdlib>

#include "app/layers/parameter_words.h"
#include "core/base/lower_case.h"

namespace mes {

std::string value_text(const ParameterDescriptor& descriptor, double value) {
  if (is_switch(descriptor)) return value != 0.0 ? "on" : "off";
  if (const auto choices = descriptor.choices; !choices.empty())
    return lower_case(std::string(choices[static_cast<std::size_t>(value - descriptor.low)]));
  // As few digits as tell it from the default, which it may be very near.
  std::string out;
  for (int digits = 4; digits <= 17; ++digits) {
    out = fmt::format("{:.{}g}", value, digits);
    if (value == descriptor.default_value || std::strtod(out.c_str(), nullptr) != descriptor.default_value) break;
  }
  if (descriptor.is_multiplier) return out + " \u00d7";
  if (descriptor.unit == "degrees") return out + "\u00b0";
  return descriptor.unit.empty() || descriptor.is_length ? out : out + ' ' + std::string(descriptor.unit);
}

std::vector<ChangedParameter> changed_parameters(const ComputationSettings& settings) {
  std::vector<ChangedParameter> out;
  for (std::size_t i = 0; i < kParameters; ++i) {
    const ParameterDescriptor& descriptor = parameter_descriptors()[i];
    if (settings.values[i] == descriptor.default_value) continue;
    out.push_back(
        {static_cast<Parameter>(i), title_of(descriptor) + ' ' + value_text(descriptor, settings.values[i])});
  }
  std::ranges::stable_partition(
      out, [](const ChangedParameter& changed) { return descriptor_of(changed.parameter).is_of_document; });
  return out;
}

std::size_t how_many_fit(std::span<const float> widths, float gap, float rest, float room) {
  std::size_t out = 0;
  float used = 0.0F;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    used += (i == 0 ? 0.0F : gap) + widths[i];
    const bool is_last = i + 1 == widths.size();
    if (used + (is_last ? 0.0F : gap + rest) <= room) out = i + 1;
  }
  return out;
}

}  // namespace mes

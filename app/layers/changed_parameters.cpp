// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/changed_parameters.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdlib>

#include "app/layers/words/parameter_words.h"
#include "core/base/lower_case.h"

namespace mes {

std::string value_text(const Parameter& descriptor, double value) {
  if (is_switch(descriptor)) return value != 0.0 ? "on" : "off";
  if (const auto& choices = descriptor.choices; !choices.empty())
    return lower_case(choices[static_cast<std::size_t>(value - descriptor.low)]);
  // Uses as few digits as distinguish the value from the default, which may be very near.
  std::string out;
  for (int digits = 4; digits <= 17; ++digits) {
    out = fmt::format("{:.{}g}", value, digits);
    if (value == descriptor.default_value || std::strtod(out.c_str(), nullptr) != descriptor.default_value) break;
  }
  if (descriptor.is_multiplier) return out + " \u00d7";
  if (descriptor.unit == "degrees") return out + "\u00b0";
  return descriptor.unit.empty() || descriptor.is_length ? out : out + ' ' + descriptor.unit;
}

std::vector<ChangedParameter> changed_parameters(std::span<const Parameter> parameters,
                                                 const ComputationSettings& settings) {
  std::vector<ChangedParameter> out;
  for (const Parameter& parameter : parameters)
    if (const double value = settings[parameter]; value != parameter.default_value)
      out.push_back({parameter, title_of(parameter) + ' ' + value_text(parameter, value)});
  std::ranges::stable_partition(out,
                                [](const ChangedParameter& changed) { return changed.parameter.is_of_document; });
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

// SPDX-License-Identifier: GPL-3.0-or-later
// What the user chose about computing: number type and parameters. Plain data.
#pragma once

#include <array>

#include "core/document/parameter.h"
#include "core/kernel/precision.h"

namespace mes {

struct ComputationSettings {
  Precision precision = Precision::fast;
  std::array<double, kParameters> values = [] {
    std::array<double, kParameters> out{};
    for (std::size_t i = 0; i < kParameters; ++i) out[i] = parameter_descriptors()[i].default_value;
    return out;
  }();

  double& operator[](Parameter parameter) { return values[static_cast<std::size_t>(parameter)]; }
  double operator[](Parameter parameter) const { return values[static_cast<std::size_t>(parameter)]; }
  bool is_on(Parameter parameter) const { return (*this)[parameter] != 0.0; }
  friend bool operator==(const ComputationSettings&, const ComputationSettings&) = default;
};

/// What another document begins with: what belongs to a document is at its default, what is the user's stays.
constexpr ComputationSettings for_another_document(ComputationSettings settings) {
  for (std::size_t i = 0; i < kParameters; ++i)
    if (parameter_descriptors()[i].is_of_document) settings.values[i] = parameter_descriptors()[i].default_value;
  return settings;
}

}  // namespace mes

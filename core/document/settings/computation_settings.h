// SPDX-License-Identifier: GPL-3.0-or-later
// The user's choices for computations: number type and parameters. Plain data.
#pragma once

#include "core/document/settings/parameter_values.h"
#include "core/kernel/precision.h"

namespace mes {

struct ComputationSettings {
  Precision precision = Precision::fast;
  ParameterValues values{};

  double& operator[](const Parameter& parameter) { return values[parameter]; }
  double operator[](const Parameter& parameter) const { return values[parameter]; }
  bool is_on(const Parameter& parameter) const { return values.is_on(parameter); }
  friend bool operator==(const ComputationSettings&, const ComputationSettings&) = default;
};

/// Settings for a new document: parameters of the document are reset to their defaults, those of the user stay.
inline ComputationSettings for_another_document(ComputationSettings settings) {
  settings.values.reset_for_another_document();
  return settings;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a variant (core/draw/variant.h) that are its own. Plain data.
#pragma once

#include "core/document/settings/computation_settings.h"

namespace mes {

struct VariantRequest {
  ComputationSettings settings;
  bool has_document = false;  ///< also has its own samples and balls
  friend bool operator==(const VariantRequest&, const VariantRequest&) = default;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What a variant (core/draw/variant.h) has of its own. Plain data.
#pragma once

#include "core/document/computation_settings.h"

namespace mes {

struct VariantRequest {
  ComputationSettings settings;
  bool has_document = false;  ///< samples and balls too
  friend bool operator==(const VariantRequest&, const VariantRequest&) = default;
};

}  // namespace mes

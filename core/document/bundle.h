// SPDX-License-Identifier: GPL-3.0-or-later
// A layer configuration with a name.
#pragma once

#include <string>

#include "core/document/layer_configuration.h"

namespace mes {

struct Bundle {
  std::string name{};  ///< UTF-8, not empty
  LayerConfiguration layers{};
  std::string description{};  ///< what there is to see, one line; may be empty
  friend bool operator==(const Bundle&, const Bundle&) = default;
};

}  // namespace mes

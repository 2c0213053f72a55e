// SPDX-License-Identifier: GPL-3.0-or-later
// A named layer configuration.
#pragma once

#include <string>

#include "core/document/settings/layer_configuration.h"

namespace mes {

struct Bundle {
  std::string name{};  ///< UTF-8, not empty
  LayerConfiguration layers{};
  std::string description{};  ///< one line about the picture; may be empty
  friend bool operator==(const Bundle&, const Bundle&) = default;
};

}  // namespace mes

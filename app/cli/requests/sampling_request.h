// SPDX-License-Identifier: GPL-3.0-or-later
// The sampling options of commands: --samples, --spacing, --jitter, --seed.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/shapes/shape.h"

namespace mes::cli {

/// Error: `usage` for a value that is not a number.
Expected<ShapeSampling> parse_sampling(const std::string& samples, const std::string& spacing,
                                       const std::string& jitter, const std::string& seed);

/// Parses a finite number. Error: `usage` with the option.
Expected<double> parse_real(std::string_view option, const std::string& text);

}  // namespace mes::cli

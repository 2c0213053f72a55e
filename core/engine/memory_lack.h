// SPDX-License-Identifier: GPL-3.0-or-later
// Lack of memory, as distinguished from failures that depend on the input or the program.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "core/draw/patch.h"

namespace mes {

/// The reason for a structure or layer that found no memory. Short enough to be stored without allocation.
inline constexpr std::string_view kOutOfMemory = "out of memory";

/// Whether a structure or a layer found no memory.
inline bool lacks_memory(std::span<const NodeReport> nodes, std::span<const LayerReport> layers) {
  const auto lacks = [](const auto& report) {
    return report.state == NodeState::failed && report.reason == kOutOfMemory;
  };
  return std::ranges::any_of(nodes, lacks) || std::ranges::any_of(layers, lacks);
}

}  // namespace mes

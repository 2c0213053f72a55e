// SPDX-License-Identifier: GPL-3.0-or-later
// What a consumer of the graph's patches holds, against a fresh computation.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/document/document.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"

namespace mes::test {

/// A graph and the consumer of its patches. One patch serves for all runs, as in the engine. What breaks a promise
/// throws.
struct Consumer {
  Graph graph{builtins()};
  FramePatch patch;
  LayerMirror mirror;

  static constexpr std::int64_t kNever = std::int64_t{1} << 62U;
  /// True when the run came to its end before it had looked so many times whether to stop.
  bool run(std::int64_t stop_at = kNever);
};

/// Empty when the consumer, whose last run was complete, holds of these layers what a fresh graph of the same
/// document draws; otherwise what differs. `last-change` is about history, and left out.
std::string difference_from_fresh(const Consumer& consumer, const Document& document,
                                  const ComputationSettings& settings, std::span<const LayerIndex> layers);

}  // namespace mes::test

// SPDX-License-Identifier: GPL-3.0-or-later
// A change of how the layers look: the part that is different, and what it is to undo and redo.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/layer_configuration.h"

namespace mes {

/// What became different between two configurations of the layers.
struct LayersChanged {
  /// A step of undo is recorded with its first change; what undo and redo do to the layers later is a change again,
  /// so that knowing how the layers look takes no history.
  enum class Role : std::uint8_t {
    noted,   ///< no step of undo: as the layers were at the beginning, or what came with an edit that was undone
    step,    ///< a step of its own
    joined,  ///< part of the step before, as when the first ball shows the layers of balls
    undone,  ///< takes the last step back, which is one of layers alone
    redone   ///< takes such a step again
  };
  std::vector<LayerConfiguration::Entry> changed{};
  std::vector<std::string> order{};  ///< of all, bottom first; empty: as before
  std::optional<BackgroundImage> image{};
  Role role = Role::noted;
  std::string name{};                 ///< of the step
  std::vector<LayersChanged> back{};  ///< of a step, or what is joined to one: the one change that undoes it
  bool is_empty() const { return changed.empty() && order.empty() && !image; }
  friend bool operator==(const LayersChanged&, const LayersChanged&) = default;
};
LayersChanged difference(const LayerConfiguration& before, const LayerConfiguration& after);
/// One change; a `LayerFold` applies many without looking at all layers for each.
void apply(const LayersChanged& change, LayerConfiguration& configuration);

/// Makes the first change one that does what both do, one after the other. Cost: O(size of both, squared).
void append(LayersChanged& first, const LayersChanged& second);

}  // namespace mes

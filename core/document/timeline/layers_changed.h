// SPDX-License-Identifier: GPL-3.0-or-later
// A change of the layer settings: the part that differs, and its role in undo and redo.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/settings/layer_configuration.h"

namespace mes {

/// The difference between two layer configurations.
struct LayersChanged {
  /// Undo steps are recorded with their first change; later undo and redo of layers are changes again, so that the look
  /// of the layers can be followed without a history.
  enum class Role : std::uint8_t {
    noted,   ///< no undo step: the initial layers, or the layer part of an edit that was undone
    step,    ///< a step of its own
    joined,  ///< part of the previous step, as when the first ball shows the layers of balls
    undone,  ///< undoes the last step, which changes only layers
    redone   ///< redoes such a step
  };
  std::vector<LayerConfiguration::Entry> changed{};
  std::vector<std::string> order{};  ///< all layers, bottom first; empty: unchanged
  std::optional<BackgroundImage> image{};
  Role role = Role::noted;
  std::string name{};                 ///< name of the step
  std::vector<LayersChanged> back{};  ///< for `step` and `joined`: the one change that undoes it
  bool is_empty() const { return changed.empty() && order.empty() && !image; }
  friend bool operator==(const LayersChanged&, const LayersChanged&) = default;
};
LayersChanged difference(const LayerConfiguration& before, const LayerConfiguration& after);
/// Applies one change; a `LayerFold` applies many without visiting all layers for each.
void apply(const LayersChanged& change, LayerConfiguration& configuration);

/// Extends the first change by the second, so that it has the effect of both. Cost: O(size of both, squared).
void append(LayersChanged& first, const LayersChanged& second);

}  // namespace mes

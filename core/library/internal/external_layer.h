// SPDX-License-Identifier: GPL-3.0-or-later
// A layer of an experiment as a layer of the graph.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <mesecina/experiment.h>

#include "core/graph/layer.h"
#include "core/library/internal/inputs.h"

namespace mesecina {
inline namespace v1 {

/// Shared by all layers made from one specification.
struct ExternalLayerSpec {
  mes::LayerDescriptor descriptor;
  std::string rows;                        ///< id of a table
  std::vector<std::string> follows;        ///< ids of tables
  std::vector<std::string> structures;     ///< all structures that it reads, without the settings
  std::vector<mes::Parameter> parameters;  ///< parameters that it reads
  Experiment::MakeDrawer make;
};

/// All structures that it reads must have been added to `set`.
mes::Layer make_external_layer(const std::shared_ptr<const ExternalLayerSpec>& spec, const mes::StructureSet& set);

}  // namespace v1
}  // namespace mesecina

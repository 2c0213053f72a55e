// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of elements of layers, remembered while they hold. So the count of a hidden layer is known without
// computing the layer, if it was shown in the same state.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "core/document/settings/computation_settings.h"
#include "core/draw/variant.h"
#include "core/graph/registry.h"

namespace mes {

class LayerCounts {
 public:
  /// Forgets all counts if the document, the settings or the registry is another one than in the last call.
  void follow(std::uint64_t document_revision, const ComputationSettings& settings,
              const std::shared_ptr<const Registry>& registry);
  void note(LayerIndex layer, std::size_t count) { counts_[layer] = count; }
  std::optional<std::size_t> of(LayerIndex layer) const;

 private:
  std::uint64_t document_revision_ = 0;
  ComputationSettings settings_;
  std::weak_ptr<const Registry> registry_;
  std::map<LayerIndex, std::size_t> counts_;
};

}  // namespace mes

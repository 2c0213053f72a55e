// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_counts.h"

namespace mes {

void LayerCounts::follow(std::uint64_t document_revision, const ComputationSettings& settings,
                         const std::shared_ptr<const Registry>& registry) {
  const bool is_same_registry = !registry_.owner_before(registry) && !registry.owner_before(registry_);
  if (document_revision == document_revision_ && settings == settings_ && is_same_registry) return;
  document_revision_ = document_revision;
  settings_ = settings;
  registry_ = registry;
  counts_.clear();
}

std::optional<std::size_t> LayerCounts::of(LayerIndex layer) const {
  const auto found = counts_.find(layer);
  return found == counts_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace mes

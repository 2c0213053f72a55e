// SPDX-License-Identifier: GPL-3.0-or-later
// Combines many layer changes into one configuration.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/document/timeline/timeline.h"

namespace mes {

/// Guarantees: after `apply` of several changes in order, `configuration` is what `mes::apply` of each of
/// them in turn gives, without the layers that `keeps` refuses. Cost of `apply`: O(size of the change), on average
/// also where layers are put in order: the order names all that stay. Threads: none.
///
/// Smallest use:
///     LayerFold fold(session.layers);
///     for (const LayersChanged& change : changes) fold.apply(change);
///     show(fold.configuration());
class LayerFold {
 public:
  using Keeps = std::function<bool(std::string_view layer)>;
  /// An empty `keeps` keeps all.
  explicit LayerFold(LayerConfiguration begin = {}, Keeps keeps = {});
  void apply(const LayersChanged& change);
  const LayerConfiguration& configuration() const { return configuration_; }
  LayerConfiguration take() && { return std::move(configuration_); }

 private:
  void put_in_order(const std::vector<std::string>& order);
  void note_places();

  LayerConfiguration configuration_;
  Keeps keeps_;
  std::unordered_map<std::string, std::size_t> place_;  // index of the first entry of each layer
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes/engine_demand.h"

#include <algorithm>
#include <vector>

#include "core/graph/registry.h"

namespace mes {

bool EngineDemand::waits_for_room(Engine& engine, const State& now) {
  if (engine.status().busy) return true;
  if (!asks_for_nothing_) {
    asks_for_nothing_ = true;
    lost_at_ = now;
    engine.set_demand({});
    return true;
  }
  return lost_at_ == now;
}

// While it computes, the engine merges all requests into one step, in which an empty demand would be lost.
bool EngineDemand::waits_to_ask_again(Engine& engine) {
  if (engine.status().busy) return true;
  if (!asks_for_nothing_) {
    asks_for_nothing_ = true;
    engine.set_demand({});
    return true;
  }
  asks_again_ = false;
  return false;
}

EngineDemand::Asked EngineDemand::asked_of(const Wanted& wanted) {
  const bool has_panes = !wanted.panes.is_empty();
  return {wanted.layers.demand_revision(), wanted.panes.revision(),
          has_panes ? std::optional(wanted.settings) : std::nullopt,
          has_panes ? std::optional(wanted.evolution) : std::nullopt, wanted.with_density};
}

bool EngineDemand::follow(Engine& engine, const Wanted& wanted, bool picture_is_lost, PaneDocuments* documents) {
  const std::uint64_t demand = wanted.layers.demand_revision() + wanted.panes.revision();
  if (picture_is_lost && waits_for_room(engine, {demand, wanted.document_revision})) return false;
  if (asks_again_ && waits_to_ask_again(engine)) return false;
  const bool is_news = !is_told(wanted) || asks_for_nothing_;
  if (is_news || (!wanted.panes.is_empty() && styled_ != wanted.layers.revision()))
    shown_ = shown_panes(wanted.registry, wanted.panes, wanted.layers, wanted.settings, wanted.evolution);
  styled_ = wanted.layers.revision();
  VariantStep beside;
  if (documents != nullptr) {
    documents->follow(shown_.versions, wanted.is_held);
    beside.deltas = documents->take_deltas();
  }
  if (is_news) beside.variants = shown_.variants;
  if (is_news || !beside.deltas.empty()) {
    std::vector<VariantLayer> layers = shown_.demand;
    const VariantLayer density = wanted.registry.find_layer("sampling-epsilon");
    const auto at = std::ranges::lower_bound(layers, density);
    if (wanted.with_density && density.layer != kNoLayer && (at == layers.end() || *at != density))
      layers.insert(at, density);
    engine.post(
        {.deltas = {}, .settings = wanted.settings, .demand = std::move(layers), .beside = std::move(beside)});
  }
  if (!is_news) return false;
  asks_for_nothing_ = false;
  seen_ = asked_of(wanted);
  return true;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/engine_demand.h"

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

bool EngineDemand::follow(Engine& engine, const LayerStack& layers, std::uint64_t document_revision,
                          bool picture_is_lost) {
  if (picture_is_lost && waits_for_room(engine, {layers.demand_revision(), document_revision})) return false;
  if (is_told(layers) && !asks_for_nothing_) return false;
  asks_for_nothing_ = false;
  seen_ = layers.demand_revision();
  engine.set_demand(layers.visible_layers());
  return true;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers the engine is asked for.
#pragma once

#include <cstdint>
#include <utility>

#include "app/model/layer_stack.h"
#include "core/engine/engine.h"

namespace mes {

/// What it guarantees: the engine is asked for the visible layers, anew when they change. After a picture was lost for
/// lack of memory it is asked for none, and for all of them again once the document or the demand has changed.
/// Threads: the window's.
class EngineDemand {
 public:
  /// Once a frame. True when the engine was asked for other layers.
  bool follow(Engine& engine, const LayerStack& layers, std::uint64_t document_revision, bool picture_is_lost);
  /// The engine has been asked for what is visible now.
  bool is_told(const LayerStack& layers) const { return seen_ == layers.demand_revision(); }

 private:
  using State = std::pair<std::uint64_t, std::uint64_t>;
  bool waits_for_room(Engine& engine, const State& now);

  std::uint64_t seen_ = 0;
  bool asks_for_nothing_ = false;
  State lost_at_{};  // revisions of demand and document
};

}  // namespace mes

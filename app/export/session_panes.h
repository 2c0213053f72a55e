// SPDX-License-Identifier: GPL-3.0-or-later
// The panes of a session, as they are at one moment of its timeline.
//
// Smallest use:
//     const SessionPanes panes(registry, session);
//     Comparison comparison = compare(registry, panes.requests({document, history, layers, settings}));
//
// Cost: O(document) a call, beside the steps of an evolution that a pane shows a state of. Threads: any.
#pragma once

#include <cstdint>
#include <vector>

#include "app/export/comparison.h"
#include "app/layers/layer_stack.h"
#include "app/model/pane_list.h"
#include "core/document/history.h"
#include "core/evolutions/evolution.h"
#include "core/io/session/session.h"

namespace mes {

class SessionPanes {
 public:
  /// The registry has to outlive it.
  SessionPanes(const Registry& registry, const Session& session);

  /// There is only the main one.
  bool is_empty() const { return list_.is_empty(); }

  /// The panes have cameras of their own; what is to be seen in each of those beside the main one, empty for everything.
  bool has_free_cameras() const { return !views_.empty(); }
  const std::vector<Box2>& views() const { return views_; }

  struct Moment {
    const Document& document;
    const History& history;  ///< of it
    const LayerStack& layers;
    const ComputationSettings& settings;
  };
  /// All panes, the main one first. Steps of the evolution are counted from its state 0: where the last edit is a state of
  /// an evolution, from what was before. A pane whose step cannot be computed is empty, and its words say why.
  std::vector<PaneRequest> requests(const Moment& now) const;

 private:
  const Registry& registry_;
  PaneList list_;
  EvolutionChoice evolution_;
  std::uint64_t steps_ = 0;  ///< of the session at its end
  std::vector<Box2> views_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The panes of a session at one moment of its timeline.
//
// Smallest use:
//     const SessionPanes panes(registry, session);
//     Comparison comparison = compare(registry, panes.requests({document, history, layers, settings}));
//
// Cost: O(document) per call, beside the steps of an evolution whose states panes show. Threads: any.
#pragma once

#include <cstdint>
#include <vector>

#include "app/export/comparison.h"
#include "app/layers/layer_stack.h"
#include "app/panes/pane_list.h"
#include "core/document/timeline/history.h"
#include "core/evolutions/evolution.h"
#include "core/io/session/session.h"

namespace mes {

class SessionPanes {
 public:
  /// The registry must outlive it.
  SessionPanes(const Registry& registry, const Session& session);

  /// True if there is only the main pane.
  bool is_empty() const { return list_.is_empty(); }

  /// True if the panes have their own cameras; `views` are those of the panes beside the main one, empty for
  /// everything.
  bool has_free_cameras() const { return !views_.empty(); }
  const std::vector<Box2>& views() const { return views_; }

  struct Moment {
    const Document& document;
    const History& history;  ///< history of the document
    const LayerStack& layers;
    const ComputationSettings& settings;
  };
  /// All panes, the main one first. Steps of the evolution are counted from its state 0; if the last edit is a state
  /// of an evolution, from the document before it. A pane whose step cannot be computed is empty, and its label has
  /// the reason.
  std::vector<PaneRequest> requests(const Moment& now) const;

 private:
  const Registry& registry_;
  PaneList list_;
  EvolutionChoice evolution_;
  std::uint64_t steps_ = 0;  ///< steps of the session at its end
  std::vector<Box2> views_;
};

}  // namespace mes

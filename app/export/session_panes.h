// SPDX-License-Identifier: GPL-3.0-or-later
// The panes of a session, as they are at one moment of its timeline.
//
// Smallest use:
//     const SessionPanes panes(session);
//     auto requests = panes.requests({document, history, layers, settings});
//     Comparison comparison = compare(std::move(*requests));
//
// Cost: O(document) a call, beside the steps of an evolution that a pane shows a state of. Threads: any.
#pragma once

#include <vector>

#include "app/export/comparison.h"
#include "app/model/layer_stack.h"
#include "app/model/pane_list.h"
#include "core/document/history.h"
#include "core/evolutions/evolution.h"
#include "core/io/session.h"

namespace mes {

class SessionPanes {
 public:
  explicit SessionPanes(const Session& session);

  /// There is only the main one.
  bool is_empty() const { return list_.is_empty(); }

  /// The panes have cameras of their own; what is to be seen in each of those beside the main one, empty for everything.
  bool has_free_cameras() const { return !views_.empty(); }
  const std::vector<Box2>& views() const { return views_; }

  struct Moment {
    const Document& document;  ///< state 0 of the evolution
    const History& history;    ///< of it
    const LayerStack& layers;
    const ComputationSettings& settings;
  };
  /// All panes, the main one first. Error: the evolution has no such state of this document.
  Expected<std::vector<PaneRequest>> requests(const Moment& now) const;

 private:
  PaneList list_;
  EvolutionChoice evolution_;
  std::vector<Box2> views_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Holds back changes of the document from the engine while the update of all structures is held.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "core/document/delta.h"

namespace mes {

/// Guarantees: while the update is held, changes wait; on release they reach the listener in their order, and later
/// ones immediately. A drag waits as one change, however many steps it has. A replacement of everything is not held:
/// it releases the update. A change for which the listener lacks memory keeps waiting, and is passed on with the next
/// call.
///
/// Smallest use:
///     UpdateHold hold([&](auto delta) { engine.post(std::move(delta)); });
///     hold.set_held(true); hold.post(delta); hold.set_held(false);
///
/// Cost: O(edits) of the waiting changes. Threads: none.
class UpdateHold {
 public:
  using Listener = std::function<void(std::shared_ptr<const DocumentDelta>)>;
  explicit UpdateHold(Listener listener) : listener_(std::move(listener)) {}

  void post(std::shared_ptr<const DocumentDelta> delta);
  void set_held(bool held);
  bool is_held() const { return is_held_; }
  /// The waiting changes, in their order.
  const std::deque<std::shared_ptr<const DocumentDelta>>& waiting() const { return waiting_; }

 private:
  void release();

  Listener listener_;
  bool is_held_ = false;
  std::deque<std::shared_ptr<const DocumentDelta>> waiting_;
};

}  // namespace mes

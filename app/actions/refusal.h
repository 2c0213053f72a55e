// SPDX-License-Identifier: GPL-3.0-or-later
// Reports a refused operation until another one succeeds.
#pragma once

#include <string>

#include "app/actions/messages.h"
#include "core/base/error.h"

namespace mes {

/// The last refusal of one part of the window. Threads: the window's.
class Refusal {
 public:
  /// `messages` must outlive it.
  explicit Refusal(Messages& messages) : messages_(messages) {}

  void say(const Error& error) {
    messages_.problem(error.message());
    said_ = messages_.problem();
  }
  /// Call it when something was done: removes the last refusal, which is stale. Problems of others stay.
  void forget() {
    if (!said_.empty() && messages_.problem() == said_) messages_.clear_problem();
    said_.clear();
  }

 private:
  Messages& messages_;
  std::string said_;
};

}  // namespace mes

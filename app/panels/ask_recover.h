// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the work that a crash left behind.
#pragma once

#include <optional>
#include <vector>

#include "app/store/autosave.h"
#include "app/ui/gui.h"

namespace mes {

class AskRecover {
 public:
  enum class Answer : std::uint8_t { none, recover, discard, later };

  void offer(std::vector<LeftWork> works) { works_ = std::move(works); }
  bool is_open() const { return !works_.empty(); }
  /// Asks again at the next start.
  void close() { works_.clear(); }
  /// Draws the question about the newest work while there is one. The answer, once.
  Answer draw(const Gui& gui);
  /// The work that was asked about.
  LeftWork take();

 private:
  std::vector<LeftWork> works_;  // newest first
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// "There is unsaved work": the question before it is lost.
#pragma once

#include <functional>
#include <string>

#include "app/ui/gui.h"

namespace mes {

class AskUnsaved {
 public:
  enum class Answer : std::uint8_t { none, save, discard, cancel };

  /// Asks, and remembers what was going to happen.
  void ask(std::string title, std::function<void()> then);
  bool is_open() const { return is_open_; }
  void close();
  /// Draws the question while it is open. The answer, once.
  Answer draw(const Gui& gui);
  /// What was going to happen; to be called when the work is saved or given up.
  std::function<void()> take_then() { return std::move(then_); }

 private:
  bool is_open_ = false;
  std::string title_;
  std::function<void()> then_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the work that a crash left behind.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/store/autosave.h"
#include "app/ui/dialogs/question.h"

namespace mes {

/// Asks about the newest work while there is any; stays open until the work is taken or removed. If cancelled, it
/// asks again at the next start.
class AskRecover final : public Question {
 public:
  /// `recover` must `take` the work, now or when there is room for it.
  void offer(std::vector<LeftWork> works, std::function<void()> recover);
  /// The work in question; nothing if it was refused meanwhile.
  std::optional<LeftWork> take();

  /// Hides the dialog while the previous work is being recovered.
  void set_waits(bool waits) { waits_ = waits; }

  bool is_open() const override { return !works_.empty() && !waits_; }
  void cancel() override { works_.clear(); }
  void draw(const Gui& gui) override;

 private:
  std::vector<LeftWork> works_;  // newest first
  std::function<void()> recover_;
  bool waits_ = false;
};

}  // namespace mes

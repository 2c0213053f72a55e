// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the work that a crash left behind.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/store/autosave.h"
#include "app/ui/dialog.h"

namespace mes {

/// Asks about the newest work while there is one; it stays open until the work is taken or removed. Cancelled, it asks
/// again at the next start.
class AskRecover final : public Dialog {
 public:
  /// `recover` is to `take` the work, now or when there is room for it.
  void offer(std::vector<LeftWork> works, std::function<void()> recover);
  /// The work that was asked about; none if it was refused meanwhile.
  std::optional<LeftWork> take();

  /// Not open while it waits: the work before is being recovered.
  void set_waits(bool waits) { waits_ = waits; }

  bool is_open() const override { return !works_.empty() && !waits_; }
  void cancel() override { works_.clear(); }
  void draw(const Gui& gui) override;

 private:
  enum class Pressed : std::uint8_t { none, recover, discard, later };
  Pressed draw_question(const Gui& gui) const;

  std::vector<LeftWork> works_;  // newest first
  std::function<void()> recover_;
  bool waits_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the last problem over the canvas until it is closed, and notices for some seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/model/messages.h"
#include "app/ui/gui.h"

namespace mes {

/// Guarantees: a notice fades by itself, later if it is long or under the pointer, and then requires no more frames.
/// Times are seconds of one clock. Threads: the window's.
class ProblemNote {
 public:
  /// Draws both in the middle of `width`, with the upper edge at `at`. Returns the height that they take.
  float draw(const Gui& gui, Messages& messages, ImVec2 at, float width, double now);
  /// Call it instead while nothing may be drawn: the time of a notice begins again.
  void wait() { notice_ends_.reset(); }
  /// Seconds until the notice begins to fade; 0 while it fades; nothing if there is none.
  std::optional<double> next_due(double now) const;

 private:
  float draw_notice(const Gui& gui, Messages& messages, ImVec2 at, float width, double now);

  std::uint64_t notice_number_ = 0;
  std::optional<double> notice_ends_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the last problem over the canvas until it is closed, and notices for some seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/actions/messages.h"
#include "app/panels/on_canvas/note_room.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: a message appears where it hides least, of equal places in the middle of the upper edge, and stays there.
/// A notice fades by itself, later if it is long or under the pointer, and then requires no more frames. Times are
/// seconds of one clock. Threads: the window's.
class ProblemNote {
 public:
  /// Draws both, the notice below the problem. Returns the height that they take in the middle of the upper edge.
  float draw(const Gui& gui, Messages& messages, const NoteRoom& room, double now);
  /// Call it instead while nothing may be drawn: the time of a notice begins again.
  void wait() { notice_ends_.reset(); }
  /// Seconds until the notice begins to fade; 0 while it fades; nothing if there is none.
  std::optional<double> next_due(double now) const;

 private:
  void choose_place(const Gui& gui, const std::string& text, const NoteRoom& room);
  bool is_notice_over(const Messages& messages, double now);

  std::string placed_text_;  // the messages for which the place was chosen
  NotePlace place_;
  std::uint64_t notice_number_ = 0;
  std::optional<double> notice_ends_;
};

}  // namespace mes

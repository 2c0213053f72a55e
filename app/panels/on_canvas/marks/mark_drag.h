// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the legend and the scale bar on the canvas with the mouse.
#pragma once

#include <optional>

#include "app/settings/paper_place.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: a press without a movement changes nothing; a dragged mark follows the pointer, stays in its room, and
/// snaps to the usual margin; cancelling a drag restores the position. Threads: the window's.
class MarkDrag {
 public:
  /// A mark that can be dragged, where it is drawn in this frame.
  struct Mark {
    const char* id;
    const char* explanation;
    ImVec2 origin;  ///< origin of its room, in screen coordinates
    Box2 box;       ///< in logical pixels from there
    Box2 room;      ///< in logical pixels from there, too
  };
  /// Call it once per frame for each drawn mark. Changes its position during a drag, and resets it on a double click
  /// or from the menu of the right button. Returns true while the mark is dragged.
  bool follow(const Gui& gui, const Mark& mark, std::optional<PaperPlace>& place);
  /// Call it after all marks.
  void end_frame();

  bool is_under_way() const { return held_ && !held_->is_cancelled; }
  /// Returns false if nothing was dragged.
  bool cancel();

 private:
  struct Held {
    const char* id;
    Vec2 corner;  // upper left corner at the beginning of the drag
    std::optional<PaperPlace> before;
    bool is_cancelled = false;
    bool is_drawn = true;  // drawn in this frame
  };
  std::optional<Held> held_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The legend and the scale bar on the canvas, dragged to other places with the mouse.
#pragma once

#include <optional>

#include "app/model/paper_place.h"
#include "app/ui/gui.h"

namespace mes {

/// What it guarantees: a press without a move changes nothing; what is dragged follows the pointer, stays in its room,
/// and takes the usual margin near to it; a cancelled drag leaves the place as it was before. Threads: the window's.
class MarkDrag {
 public:
  /// What can be dragged, where it is drawn in this frame.
  struct Mark {
    const char* id;
    const char* explanation;
    ImVec2 origin;  ///< of its room, in screen coordinates
    Box2 box;       ///< in logical pixels from there
    Box2 room;      ///< likewise
  };
  /// Once a frame for each mark that is drawn. Changes its place while it is dragged, and takes it away by a double
  /// click or from the menu of the right button. True while it is dragged.
  bool follow(const Gui& gui, const Mark& mark, std::optional<PaperPlace>& place);
  /// After all of them.
  void end_frame();

  bool is_under_way() const { return held_ && !held_->is_cancelled; }
  /// False when nothing was dragged.
  bool cancel();

 private:
  struct Held {
    const char* id;
    Vec2 corner;  // the upper left one, when it was taken
    std::optional<PaperPlace> before;
    bool is_cancelled = false;
    bool is_drawn = true;  // in this frame
  };
  std::optional<Held> held_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The legend and the scale bar over the canvas, where they are drawn and dragged.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "app/panels/on_canvas/marks/canvas_marks.h"
#include "app/panels/on_canvas/marks/mark_drag.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/settings/settings.h"
#include "app/ui/screen/screen.h"
#include "app/window/work/drawing_board.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Threads: the window's.
class WindowMarks {
 public:
  struct Uses {
    Screen& screen;
    Workspace& work;
    DrawingBoard& board;
    Settings& settings;
    Messages& messages;
  };
  explicit WindowMarks(const Uses& uses) : uses_(uses) {}

  /// Draws them over the main pane, whose corners on the screen are `low` and `high`.
  void draw(ImVec2 low, ImVec2 high);
  /// The size of the legend with its margin, in framebuffer pixels; zero if it is dragged away from its corner, or not
  /// shown.
  Vec2 legend_in_corner() const;
  /// Whether a box on the screen would hide a part of them.
  bool are_hidden_by(const Box2& box) const;
  MarkDrag& drag() { return drag_; }
  /// Where they were drawn last.
  const MarkPlaces& places() const { return places_; }

 private:
  MarksPlace draw_scale_marks(ImVec2 low, ImVec2 high);
  std::optional<Box2> draw_legend(ImVec2 low, const MarksPlace& marks);
  std::function<std::size_t(const Box2&)> drawing_below(ImVec2 origin) const;

  Uses uses_;
  bool lacks_legend_ = false;  // the legend has no room, which a message has said
  MarkDrag drag_;
  MarkPlaces places_;
  std::optional<Box2> legend_;   // in logical pixels of the pane
  std::vector<Box2> on_screen_;  // the boxes of both
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_marks.h"

#include <algorithm>
#include <string>

#include "app/panels/on_canvas/marks/canvas_legend.h"

namespace mes {

void WindowMarks::draw(ImVec2 low, ImVec2 high) {
  const MarksPlace marks = draw_scale_marks(low, high);
  legend_ = draw_legend(low, marks);
  drag_.end_frame();
  const auto place_in_room = [&](const Box2& box) {
    constexpr double kReach = 0.5;
    return place_of(box.low, box.high - box.low, marks.room, kReach);
  };
  places_ = {legend_ ? std::optional(place_in_room(*legend_)) : std::nullopt,
             marks.bar ? std::optional(place_in_room(*marks.bar)) : std::nullopt};
  on_screen_.clear();
  const double unit = uses_.screen.gui.unit();
  for (const std::optional<Box2>& box : {legend_, marks.bar})
    if (box) on_screen_.push_back({Vec2{low.x, low.y} + unit * box->low, Vec2{low.x, low.y} + unit * box->high});
}

Vec2 WindowMarks::legend_in_corner() const {
  if (!legend_ || uses_.settings.legend_at) return {};
  const double scale = uses_.screen.window->pixel_ratio() * uses_.screen.gui.unit();
  return scale * (legend_->high - legend_->low + Vec2{kUsualMarginPx, kUsualMarginPx});
}

bool WindowMarks::are_hidden_by(const Box2& box) const {
  return std::ranges::any_of(on_screen_, [&](const Box2& mark) {
    return mark.low.x < box.high.x && box.low.x < mark.high.x && mark.low.y < box.high.y && box.low.y < mark.high.y;
  });
}

// Measures how much of the drawing lies below a box, in logical pixels from `origin`.
std::function<std::size_t(const Box2&)> WindowMarks::drawing_below(ImVec2 origin) const {
  return [this, at = Vec2{origin.x, origin.y}](const Box2& box) {
    const double unit = uses_.screen.gui.unit();
    return uses_.board.hidden_by({at + unit * box.low, at + unit * box.high});
  };
}

// Draws the scale marks; returns the room left for the legend, in logical pixels.
MarksPlace WindowMarks::draw_scale_marks(ImVec2 low, ImVec2 high) {
  const Gui& gui = uses_.screen.gui;
  const double ratio = uses_.screen.window->pixel_ratio();
  const std::string unit = unit_of_lengths(uses_.work.document());
  const MarksPlace marks = CanvasMarks{gui, uses_.board.picture(), {uses_.board.view().camera()}, unit}.draw(
      uses_.settings.marks, low, high, ratio, drawing_below(low));
  // If all panes have the same scale, one bar is enough.
  const Canvas& canvas = uses_.board.canvas();
  for (std::size_t i = 1; i < canvas.panes().places().size(); ++i) {
    ScaleMarks beside = uses_.settings.marks;
    beside.bar = beside.bar && canvas.views().is_own(i);
    const Vec2 shift = canvas.panes().shift(i);
    const ImVec2 on_screen(static_cast<float>(shift.x / ratio), static_cast<float>(shift.y / ratio));
    CanvasMarks{gui, uses_.board.picture(), {canvas.views().of(i).camera(), on_screen}, unit}.draw(
        beside, low, high, ratio, drawing_below({low.x + on_screen.x, low.y + on_screen.y}));
  }
  if (marks.bar && drag_.follow(gui,
                                {"##scale-bar-handle", "Drag to move the scale bar; double click to put it back", low,
                                 *marks.bar, marks.room},
                                uses_.settings.marks.bar_at))
    uses_.screen.clock.want(2);
  return marks;
}

// Returns the box of the legend in logical pixels of the room.
std::optional<Box2> WindowMarks::draw_legend(ImVec2 low, const MarksPlace& marks) {
  if (marks.room.is_empty()) return {};
  const Gui& gui = uses_.screen.gui;
  std::optional<PaperPlace>& place = uses_.settings.legend_at;
  const auto [box, lacks_room] =
      CanvasLegend{gui, uses_.board.picture(), uses_.work.layers(),
                   legend_scope(uses_.settings.show_legend, uses_.settings.show_key), drawing_below(low)}
          .draw(place, low, marks);
  if (lacks_room && !lacks_legend_)
    uses_.messages.notice("The legend has no room: enlarge the window or show fewer layers.");
  lacks_legend_ = lacks_room;
  if (!box) return {};
  if (drag_.follow(gui,
                   {"##legend-handle", "Drag to move the legend; double click to put it back", low, *box, marks.room},
                   place))
    uses_.screen.clock.want(2);
  return box;
}

}  // namespace mes

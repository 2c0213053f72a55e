// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/canvas_marks.h"

#include <cmath>
#include <utility>

#include "app/panels/on_canvas/marks/paper_on_canvas.h"

namespace mes {

MarksPlace CanvasMarks::draw(ScaleMarks marks, ImVec2 low, ImVec2 high, double pixel_ratio,
                             const std::function<std::size_t(const Box2&)>& hides) const {
  const auto in_pixels = [pixel_ratio](float at) { return static_cast<int>(std::lround(pixel_ratio * at)); };
  const int left = in_pixels(low.x);
  const int top = in_pixels(low.y);
  const int width = in_pixels(high.x) - left;
  const int height = in_pixels(high.y) - top;
  if (width < 1 || height < 1) return {};
  SeenPlane plane = seen_plane(pane.camera.part(left, top, width, height), pixel_ratio * gui.unit());
  plane.unit = unit;
  const MeasureText measure = measure_on_canvas(gui);
  // A corner that hides less is not better, only a free one: the bar stays while one edits.
  if (hides)
    marks = with_free_bar(marks, plane, measure, [&](const Box2& box) {
      return std::pair<std::size_t, std::size_t>(0, hides(box) == 0 ? 0 : 1);
    });
  if (!marks.is_empty())
    paint_on_canvas(gui, layout_scale_marks(marks, plane, measure, picture.canvas()),
                    {low.x + pane.shift.x, low.y + pane.shift.y});
  return place_of_marks(marks, plane, measure);
}

}  // namespace mes

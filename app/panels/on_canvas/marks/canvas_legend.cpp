// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/canvas_legend.h"

#include <cmath>

#include "app/layers/words/scalar_words.h"
#include "app/panels/on_canvas/marks/paper_on_canvas.h"
#include "app/picture/paper/legend_place.h"

namespace mes {

namespace {

constexpr double kMostOfCanvas = 1.0 / 3.0;

}  // namespace

CanvasLegend::Drawn CanvasLegend::draw(const std::optional<PaperPlace>& place, ImVec2 origin,
                                       const MarksPlace& marks) const {
  std::vector<LegendEntry> entries = picture.legend(picture.layers_on_screen(layers), scope);
  for (LegendEntry& entry : entries) entry.scalar = spoken_scalar(entry.scalar);
  const PlacedLegend legend =
      place_legend(entries, measure_on_canvas(gui), 1.0,
                   {.room = marks.room,
                    .bar = marks.longest_bar,
                    .place = place,
                    // A corner that hides less is not better, only a free one: the legend stays while one edits.
                    .hides = [this](const Box2& box) { return hides(box) == 0 ? 0U : 1U; },
                    .most_of_room = kMostOfCanvas},
                   picture.canvas());
  if (legend.drawing.is_empty()) return {.lacks_room = legend.lacks_room};
  const float unit = gui.unit();
  // Rounded to whole pixels, because a frame between pixels is blurred.
  paint_on_canvas(gui, legend.drawing,
                  {std::round(origin.x + static_cast<float>(legend.corner.x) * unit),
                   std::round(origin.y + static_cast<float>(legend.corner.y) * unit)});
  return {.box = Box2{legend.corner, legend.corner + Vec2{legend.drawing.width, legend.drawing.height}}};
}

}  // namespace mes

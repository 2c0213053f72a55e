// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/canvas_legend.h"

#include <cmath>

#include "app/layers/scalar_words.h"
#include "app/panels/paper_on_canvas.h"
#include "app/picture/legend.h"

namespace mes {

std::optional<Box2> CanvasLegend::draw(const std::optional<PaperPlace>& place, ImVec2 origin,
                                       const Box2& room) const {
  std::vector<LegendEntry> entries = picture.legend(visible_layers(layers), scope);
  if (entries.empty()) return std::nullopt;
  for (LegendEntry& entry : entries) entry.scalar = spoken_scalar(entry.scalar);
  const PaperDrawing legend =
      layout_legend(entries, measure_on_canvas(gui), room.height() - 2.0 * kUsualMarginPx, picture.canvas());
  const Vec2 size{legend.width, legend.height};
  const Vec2 at = placed(place.value_or(PaperPlace{}), size, room);
  const float unit = gui.unit();
  // On whole pixels, or its frame would be blurred.
  paint_on_canvas(gui, legend,
                  {std::round(origin.x + static_cast<float>(at.x) * unit),
                   std::round(origin.y + static_cast<float>(at.y) * unit)});
  return Box2{at, at + size};
}

}  // namespace mes

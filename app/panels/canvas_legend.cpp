// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/canvas_legend.h"

#include <cmath>

#include "app/model/scalar_words.h"
#include "app/panels/paper_on_canvas.h"
#include "app/picture/legend.h"

namespace mes {

ImVec2 CanvasLegend::draw(ImVec2 corner, float room) const {
  std::vector<LegendEntry> entries = picture.legend(layers, scope);
  if (entries.empty()) return {};
  for (LegendEntry& entry : entries) entry.scalar = spoken_scalar(entry.scalar);
  const float unit = gui.unit();
  const PaperDrawing legend =
      layout_legend(entries, measure_on_canvas(gui), static_cast<double>(room / unit), picture.canvas());
  const ImVec2 at(std::floor(corner.x - static_cast<float>(legend.width) * unit),
                  std::floor(corner.y - static_cast<float>(legend.height) * unit));
  paint_on_canvas(gui, legend, at);
  return {static_cast<float>(legend.width) * unit, static_cast<float>(legend.height) * unit};
}

}  // namespace mes

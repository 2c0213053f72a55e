// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/figure_legend.h"

#include "app/picture/internal/legend_entries.h"

namespace mes {
namespace {

std::vector<LegendEntry> figure_legend_of(const figure::Drawing& drawing, LegendScope scope) {
  return entries_of(
      drawing.layers, drawing.views, scope, [&](const render::LayerView& view) { return shown_map(drawing, view); },
      [&](VariantLayer layer, PrimitiveKind kind) { return !drawing.mirror.instances(layer, kind).empty(); });
}

}  // namespace

bool has_legend(const figure::Drawing& drawing, LegendScope scope) {
  return !figure_legend_of(drawing, scope).empty();
}

bool add_legend(figure::Figure& figure, const figure::Drawing& drawing, LegendScope scope,
                const LegendSurroundings& around, const PaperFonts& fonts) {
  const PlacedLegend legend =
      place_legend(figure_legend_of(drawing, scope), fonts, drawing.scale, around, drawing.background);
  const double points = drawing.scale * figure::kPointsPerPixel;
  if (!legend.drawing.is_empty())
    add_to(figure, fonts, legend.drawing, points * legend.corner, drawing.scale * legend.shrink);
  return !legend.lacks_room;
}

}  // namespace mes

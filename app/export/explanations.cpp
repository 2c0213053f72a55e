// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/explanations.h"

#include "app/picture/shapes_below.h"

namespace mes {

Explanations explain(const FigureRequest& request, const FigureSource& source, const SeenPlane& plane,
                     double title_height, std::span<const LegendEntry> entries, const LegendStrip& strip,
                     const PaperFonts& fonts) {
  const ShownLayers& shown = request.shown;
  const MeasureText measure = measure_with(fonts, shown.scale);
  Explanations out;
  if (request.with_annotations && !source.annotations.is_empty())
    out.annotated = layout_annotations(source.annotations, plane, measure, shown.background);
  out.plane = plane;
  out.plane.covered_above = title_height;
  out.plane.unit = unit_of_lengths(source.document);
  LegendSurroundings around{
      .place = request.legend_at,
      .words = out.annotated.words,
      .hides = [&](const Box2& box) { return shapes_below(source.mirror, shown.layers, below(out.plane, box)); },
      .keeps_letters = request.keeps_letters,
      .strip = strip};
  out.marks = with_free_bar(request.marks, out.plane, measure, [&](const Box2& box) { return around.cost_of(box); });
  const MarksPlace place = place_of_marks(out.marks, out.plane, measure);
  around.room = place.room;
  around.bar = place.longest_bar;
  out.legend = place_legend(entries, fonts, shown.scale, around, shown.background);
  return out;
}

}  // namespace mes

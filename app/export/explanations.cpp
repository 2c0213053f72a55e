// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/explanations.h"

#include <algorithm>

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
  // Lines of a diagram go on beyond the samples, where there is nothing that a legend should leave free.
  const auto hides = [&](const Box2& box) {
    constexpr std::size_t kAmongSamples = 16;
    const Box2 hidden = below(out.plane, box);
    const Box2 among{{std::max(hidden.low.x, source.bounds.low.x), std::max(hidden.low.y, source.bounds.low.y)},
                     {std::min(hidden.high.x, source.bounds.high.x), std::min(hidden.high.y, source.bounds.high.y)}};
    const std::size_t beyond = shapes_below(source.mirror, shown.layers, hidden);
    return among.is_empty() ? beyond : beyond + kAmongSamples * shapes_below(source.mirror, shown.layers, among);
  };
  LegendSurroundings around{.place = request.legend_at,
                            .words = out.annotated.words,
                            .hides = hides,
                            .keeps_letters = request.keeps_letters,
                            .strip = strip};
  // In a strip the bar is at the other end than the legend.
  ScaleMarks wanted = request.marks;
  if (strip.below > 0.0 && !wanted.bar_at) wanted.bar_at = PaperPlace{.corner = PaperCorner::bottom_left};
  out.marks = with_free_bar(wanted, out.plane, measure, [&](const Box2& box) { return around.cost_of(box); });
  const MarksPlace place = place_of_marks(out.marks, out.plane, measure);
  around.room = place.room;
  around.bar = place.longest_bar;
  out.legend = place_legend(entries, fonts, shown.scale, around, shown.background);
  return out;
}

}  // namespace mes

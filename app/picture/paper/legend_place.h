// SPDX-License-Identifier: GPL-3.0-or-later
// The position of a legend: one rule for pictures in pixels, for vector graphics and for the window.
//
// Guarantees:
//  1. The scale bar has priority: the legend never covers it, nor the areas of title, caption and axes.
//  2. A legend with a given position is there; if the scale bar is there, the legend is next to it, by the shortest
//     way.
//  3. Any other legend is in a corner, or beside the scale bar there. It chooses the positions that cover the fewest
//     texts of annotations, of these the ones that hide the least of the drawing, and of these the first of lower
//     right, lower left, upper right, upper left. In a sequence of pictures it ignores texts and drawing, so that it
//     does not move.
//  4. A picture that can leave a strip at its lower or right edge free does so if the legend then hides at most a
//     quarter of what it would hide in the best corner. Of both edges it takes the one that leaves the drawing larger.
//  5. If no such position is free, the legend lists fewer layers and counts the others: as many as fit above or below
//     the scale bar, or else one. If not even one layer has room, the legend is left out.
//  6. The window leaves out a legend that would take more than a third of the room, whatever it lies on.
//
// Smallest use:
//     const MarksPlace marks = place_of_marks(...);
//     const PlacedLegend legend = place_legend(entries, fonts, scale, {.room = marks.room, .bar = marks.longest_bar}, kWhiteCanvas);
//     paint(image, fonts, legend, scale);
//
// Cost: some hundred rectangles per layer, and at most eight calls of `hides`. Threads: any.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "app/picture/paper/legend.h"
#include "app/picture/paper/paper_drawing.h"
#include "app/settings/paper_place.h"
#include "core/base/geometry/box2.h"

namespace mes {

/// An edge of a picture that is left free for the legend, in logical pixels; at most one is above 0.
struct LegendStrip {
  double below = 0.0;
  double right = 0.0;
  bool is_empty() const { return below == 0.0 && right == 0.0; }
};

/// The other contents of the picture, in its logical pixels, y down.
struct LegendSurroundings {
  Box2 room{};                        ///< the area that title, caption and axes leave free
  std::optional<Box2> bar{};          ///< box of the scale bar
  std::optional<PaperPlace> place{};  ///< the position given to the legend
  std::span<const Box2> words{};      ///< boxes of the texts of annotations
  /// Returns how much of the drawing a box would hide; null: unknown.
  std::function<std::size_t(const Box2&)> hides{};
  bool keeps_letters = false;  ///< a small picture has a legend of the usual size
  double most_of_room = 1.0;   ///< a legend that takes a larger share of the room is left out
  LegendStrip strip{};         ///< where the legend is then: at the right end, in several columns if it is below

  /// The number of these texts that the box covers, and the amount of drawing.
  std::pair<std::size_t, std::size_t> cost_of(const Box2& box) const;
};

struct PlacedLegend {
  PaperDrawing drawing{};   ///< empty: no legend
  double shrink = 1.0;      ///< logical pixels of the picture per logical pixel of the drawing
  Vec2 corner{};            ///< upper left, in logical pixels of the picture
  double from_below = 0.0;  ///< distance of the upper edge from the lower end of the room, such as above a scale bar
  std::pair<std::size_t, std::size_t> hides{};  ///< the number of texts that it covers, and the amount of drawing
  bool lacks_room = false;                      ///< it was left out for lack of room
  Vec2 size() const { return shrink * Vec2{drawing.width, drawing.height}; }
};

/// A picture laid out with a strip for the legend.
struct LegendTrial {
  PlacedLegend legend;
  double width = 0.0;  ///< of the picture, in logical pixels
  double height = 0.0;
  double units_per_pixel = 1.0;  ///< the larger, the smaller the drawing
};

/// The strip for the legend of a picture; empty: the legend is in a corner. Calls `lay_out` at most five times.
LegendStrip strip_for_legend(const std::function<LegendTrial(const LegendStrip&)>& lay_out);

/// `measure` is for the texts of the legend, which is drawn smaller by `shrink`.
PlacedLegend place_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double shrink,
                          const LegendSurroundings& around, const std::optional<Rgb>& background);
/// The same for a picture with `scale` pixels per logical pixel; the legend is somewhat smaller in a small picture.
PlacedLegend place_legend(std::span<const LegendEntry> entries, const PaperFonts& fonts, double scale,
                          const LegendSurroundings& around, const std::optional<Rgb>& background);

/// The remark on a legend that was left out.
inline constexpr const char* kLegendLacksRoom =
    "the legend is left out: there is no room for it beside the scale bar";

/// Paints on a picture with `scale` pixels per logical pixel, at whole pixels, because its frame would be blurred
/// otherwise.
void paint(render::Image& image, const PaperFonts& fonts, const PlacedLegend& legend, double scale);

}  // namespace mes

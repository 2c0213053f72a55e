// SPDX-License-Identifier: GPL-3.0-or-later
// Where a legend stands: one rule for pictures in pixels, for vector graphics and for the window.
//
// What it guarantees:
//  1. The scale bar comes first, and the legend never covers it, nor what title, caption and axes take.
//  2. Where the legend was given a place, it stands there; where that is the scale bar's, next to it, the shortest way.
//  3. Otherwise it stands in a corner, or beside the scale bar there: where it covers the fewest words of annotations, of
//     these places where it hides the least of the drawing, and of these in the first of lower right, lower left, upper
//     right, upper left. In pictures that follow one another nothing is known of words and drawing, so that it stays.
//  4. If no such place is free, the legend lists fewer layers and counts the others: as many as fit above or below the
//     scale bar, or else one. If not even one layer has room, the legend is left out.
//
// Smallest use:
//     const MarksPlace marks = place_of_marks(...);
//     const PlacedLegend legend = place_legend(entries, fonts, scale, {.room = marks.room, .bar = marks.longest_bar}, kWhiteCanvas);
//     paint(image, fonts, legend, scale);
//
// Cost: some hundred rectangles a layer, and eight calls of `hides` at most. Threads: any.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "app/model/paper_place.h"
#include "app/picture/legend.h"
#include "app/picture/paper_drawing.h"
#include "core/base/box2.h"

namespace mes {

/// What it shares a picture with, in logical pixels of that, y down.
struct LegendSurroundings {
  Box2 room{};                        ///< what title, caption and axes leave of the picture
  std::optional<Box2> bar{};          ///< of the scale bar
  std::optional<PaperPlace> place{};  ///< that was given to the legend
  std::span<const Box2> words{};      ///< of annotations
  /// How much of the drawing a box would hide; null: it is not known.
  std::function<std::size_t(const Box2&)> hides{};
};

struct PlacedLegend {
  PaperDrawing drawing{};   ///< empty: there is none
  double shrink = 1.0;      ///< logical pixels of the picture per logical pixel of the drawing
  Vec2 corner{};            ///< upper left, in logical pixels of the picture
  bool lacks_room = false;  ///< there is none for want of room
};

/// `measure` is for texts of the legend, which is drawn smaller by `shrink`.
PlacedLegend place_legend(std::span<const LegendEntry> entries, const MeasureText& measure, double shrink,
                          const LegendSurroundings& around, const std::optional<Rgb>& background);
/// The same for a picture with so many pixels per logical pixel; the legend is somewhat smaller in a small one.
PlacedLegend place_legend(std::span<const LegendEntry> entries, const PaperFonts& fonts, double scale,
                          const LegendSurroundings& around, const std::optional<Rgb>& background);

/// What there is to say of a legend that lacks room.
inline constexpr const char* kLegendLacksRoom =
    "the legend is left out: there is no room for it beside the scale bar";

/// On a picture with so many pixels per logical pixel, at whole pixels, or its frame would be blurred.
void paint(render::Image& image, const PaperFonts& fonts, const PlacedLegend& legend, double scale);

}  // namespace mes

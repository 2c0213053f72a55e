// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of a figure: the one of a picture of the same size, as text and rectangles on the page.
//
// Cost: O(shapes of the figure). Threads: any, with a figure of its own.
#pragma once

#include <optional>

#include "app/picture/legend.h"
#include "render/figure/figure_of.h"

namespace mes {

/// Where it is to stand.
struct FigureLegendPlace {
  std::optional<PaperPlace> place{};  ///< none: the corner where it hides the fewest shapes
  Box2 room{};                        ///< what title, axes and caption leave of the page, in points
};
/// Adds nothing where it would explain no layer.
void add_legend(figure::Figure& figure, const figure::Drawing& drawing, LegendScope scope,
                const FigureLegendPlace& where, const PaperFonts& fonts);

/// True if `add_legend` would add something.
bool has_legend(const figure::Drawing& drawing, LegendScope scope);

}  // namespace mes

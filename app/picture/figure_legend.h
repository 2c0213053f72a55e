// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of a figure: that of a picture of the same size, as text and rectangles on the page.
//
// Cost: O(shapes of the figure). Threads: any, with a figure of its own.
#pragma once

#include "app/picture/legend_place.h"
#include "render/figure/figure_of.h"

namespace mes {

/// Adds nothing if it would explain no layer. Returns false if the legend is left out for lack of room.
bool add_legend(figure::Figure& figure, const figure::Drawing& drawing, LegendScope scope,
                const LegendSurroundings& around, const PaperFonts& fonts);

/// True if it would explain some layer.
bool has_legend(const figure::Drawing& drawing, LegendScope scope);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The background of the drawing, and the colours that depend on it.
//
// Black is ink, not a colour: on a dark canvas it is drawn light, in the window and in pictures. The style that is
// stored, shared and shown in the colour chooser stays black, so a bundle fits either canvas. Other colours do not
// change.
//
// Smallest use:
//     const Rgb background = canvas_background(settings);
//     view.style = drawn_on(view.style, background);
//
// Cost: a few operations. Threads: any.
#pragma once

#include <optional>

#include "app/settings/settings.h"
#include "core/base/color.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

inline constexpr Rgb kWhiteCanvas{0xFF, 0xFF, 0xFF};
inline constexpr Rgb kLightGreyCanvas{0xEE, 0xF0, 0xF2};
inline constexpr Rgb kDarkCanvas{0x1B, 0x1E, 0x22};
inline constexpr Rgb kBlackCanvas{0x00, 0x00, 0x00};

/// The background chosen in the settings, or else that of the theme.
Rgb canvas_background(const Settings& settings);

/// True if white text is more legible on it than black text, by the contrast ratio of WCAG 2.2.
bool is_dark(Rgb background);

/// True if a colour, drawn on the canvas, has less than 3 to 1 to it or to the surroundings, by the contrast ratio of
/// WCAG 2.2: it cannot be told from them without an outline.
bool is_faint(Rgb color, double opacity, Rgb canvas, Rgb surroundings);

/// The style as it is drawn on a background. On a transparent one, whose surroundings are unknown, it does not change.
LayerStyle drawn_on(LayerStyle style, const std::optional<Rgb>& background);

/// The colour that marks the selection and the element under the pointer.
Rgb mark_color(Rgb background);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What is behind the drawing, and what has to look different because of it.
//
// Black is ink, not a colour: on a dark canvas it is drawn light, in the window and in pictures. The style that is
// stored, shared and shown in the colour chooser stays black, so that a bundle fits either canvas. Other colours are
// drawn as they are.
//
// Smallest use:
//     const Rgb background = canvas_background(settings);
//     view.style = drawn_on(view.style, background);
//
// Cost: nothing. Threads: any.
#pragma once

#include <optional>

#include "app/model/settings.h"
#include "core/base/color.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

inline constexpr Rgb kWhiteCanvas{0xFF, 0xFF, 0xFF};
inline constexpr Rgb kLightGreyCanvas{0xEE, 0xF0, 0xF2};
inline constexpr Rgb kDarkCanvas{0x1B, 0x1E, 0x22};
inline constexpr Rgb kBlackCanvas{0x00, 0x00, 0x00};

/// The chosen one, else that of the theme.
Rgb canvas_background(const Settings& settings);

/// White writing is easier to read on it than black: by the contrast ratio of WCAG 2.2.
bool is_dark(Rgb background);

/// Of a canvas that is transparent nobody knows on what it will lie; there everything stays as it is.
LayerStyle drawn_on(LayerStyle style, const std::optional<Rgb>& background);

/// Of what is selected or under the pointer.
Rgb mark_color(Rgb background);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture is asked to be, read from the words of the command line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/box2.h"
#include "core/base/color.h"
#include "core/base/error.h"
#include "core/document/layer_configuration.h"
#include "core/draw/layer_mirror.h"

namespace mes::cli {

struct PictureSize {
  int width = 0;
  int height = 0;
};

/// "1600x1200"; each side from 1 to 32768. Error: `usage`.
Expected<PictureSize> parse_size(const std::string& text);

/// "X0,Y0,X1,Y1", any two opposite corners; nothing for "fit". Error: `usage`.
Expected<std::optional<Box2>> parse_view(const std::string& text);

/// "RRGGBB", with or without #; nothing for anything else.
std::optional<Rgb> parse_rgb(std::string_view text);

/// "RRGGBB", with or without #; nothing for "transparent" and "none". Error: `usage`.
Expected<std::optional<Rgb>> parse_background(const std::string& text);

/// "FILE" or "FILE:X,Y,WIDTH"; without the numbers the width is 0. Whatever else follows a colon belongs to the name.
BackgroundImage parse_image(const std::string& text);

/// What "fit" shows: the samples, and the shown layers that count for it. Those may carry the box beyond the samples
/// by a tenth of their extent at most: the balls of a good sample stay within that, and one huge ball at a hole of
/// the curve must not shrink everything else to a dot.
Box2 fit_box(const Box2& samples, const LayerMirror& mirror, std::span<const LayerIndex> layers);

/// Median distance from a sample to the nearest other one, 0 when there are fewer than two; from a few hundred samples when
/// there are many. O(n log n).
double typical_spacing(std::vector<Vec2> samples);

}  // namespace mes::cli

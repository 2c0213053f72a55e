// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the properties of a picture in the words of the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/color.h"
#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/document/settings/layer_configuration.h"

namespace mes::cli {

struct PictureSize {
  int width = 0;
  int height = 0;
};

/// Parses "1600x1200"; each side from 1 to 32768. Error: `usage`.
Expected<PictureSize> parse_size(const std::string& text);

/// Parses "X0,Y0,X1,Y1", any two opposite corners; returns nothing for "fit". Error: `usage`.
Expected<std::optional<Box2>> parse_view(const std::string& text);

/// Parses "RRGGBB", with or without #; returns nothing for any other text.
std::optional<Rgb> parse_rgb(std::string_view text);

/// Parses "RRGGBB", with or without #; returns nothing for "transparent" and "none". Error: `usage`.
Expected<std::optional<Rgb>> parse_background(const std::string& text);

/// Parses "FILE" or "FILE:X,Y,WIDTH"; without the numbers the width is 0. Any other text after a colon is part of the
/// name.
BackgroundImage parse_image(const std::string& text);

}  // namespace mes::cli

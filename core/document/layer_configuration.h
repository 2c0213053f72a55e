// SPDX-License-Identifier: GPL-3.0-or-later
// Everything about what is shown and how, but nothing of what it is computed from: what a bundle holds.
#pragma once

#include <string>
#include <vector>

#include "core/base/vec2.h"
#include "core/draw/layer_style.h"

namespace mes {

/// A picture below the drawing, to be traced. Its opacity is that of the layer `image`.
struct BackgroundImage {
  std::string file{};  ///< empty: none
  Vec2 center{};       ///< document units
  double width = 0.0;  ///< document units from its left to its right edge, > 0; the height follows from the file
  /// Turned as its Exif data say. Earlier versions laid pixels as they are stored, and their sessions keep that, so that what
  /// was drawn on a picture stays on it.
  bool is_upright = true;
  friend bool operator==(const BackgroundImage&, const BackgroundImage&) = default;
};

struct LayerConfiguration {
  struct Entry {
    std::string layer;  ///< public id; readers skip an id they do not know
    bool visible = false;
    LayerStyle style{};
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  std::vector<Entry> layers{};  ///< bottom first; a layer that is not named is hidden and keeps its style
  BackgroundImage image{};
  friend bool operator==(const LayerConfiguration&, const LayerConfiguration&) = default;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a bundle: all settings of the picture, but none of the computations.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/draw/layer_style.h"

namespace mes {

/// A picture below the drawing, to be traced. Its opacity is that of the layer `image`.
struct BackgroundImage {
  std::string file{};  ///< empty: none
  Vec2 center{};       ///< document units
  double width = 0.0;  ///< document units from its left to its right edge, > 0; the height follows from the file
  /// The picture is rotated as its Exif data say. Earlier versions ignored these data; their sessions keep doing so, so
  /// that drawings stay aligned with the picture.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

// The picture is not geometry: the program that draws the layers draws it at the position of this layer.
Layer make_image_layer(const StructureSet& /*set*/) {
  return make_layer({.id = "image",
                     .name = "Image",
                     .tooltip = "A picture below the drawing, for tracing shapes",
                     .group = LayerGroup::samples,
                     .in_paper = true,
                     .in_fit_box = false},
                    {});
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how much of a drawing lies below something put on it. The result is the same for pixels and for vector
// graphics, so that a legend is in the same corner of both.
//
// Cost: O(primitives of the layers), some nanoseconds each. Threads: any, while no patch is applied.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/geometry/box2.h"
#include "core/draw/layer_mirror.h"

namespace mes {

/// The number of primitives of the layers with a part in the box, in units of the document. For an arc, its bounds
/// and its whole circle count. The inside of a circle does not count, that of disks and triangles does.
std::size_t shapes_below(const LayerMirror& mirror, std::span<const VariantLayer> layers, const Box2& box);

}  // namespace mes

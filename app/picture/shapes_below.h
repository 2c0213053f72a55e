// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a drawing lies below something that is put on it. The same for pixels and for vector graphics, so that a
// legend stands in the same corner of both.
//
// Cost: O(primitives of the layers), some nanoseconds each. Threads: any, while no patch is applied.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/box2.h"
#include "core/draw/layer_mirror.h"

namespace mes {

/// How many primitives of the layers have a part in the box, in units of the document. Of an arc its bounds count, and
/// its whole circle. Inner parts of circles do not count, those of disks and triangles do.
std::size_t shapes_below(const LayerMirror& mirror, std::span<const VariantLayer> layers, const Box2& box);

}  // namespace mes

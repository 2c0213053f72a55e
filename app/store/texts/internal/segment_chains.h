// SPDX-License-Identifier: GPL-3.0-or-later
// The chains that the segments and parabolas of a layer form.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/draw/layer_mirror.h"

namespace mes {

/// A chain of numbered points; a closed one does not repeat its first point.
struct SegmentChain {
  bool closed = false;
  std::vector<std::uint32_t> points;
  std::vector<std::uint32_t> segments;  ///< numbers of the instances: segments[i] joins points[i] and the next
};

/// Guarantees: points are numbered by first appearance; equal ends of segments are one point. Each segment of
/// positive length is in one chain. A chain joins two points that do not have exactly two segments; the remaining
/// chains are closed.
struct SegmentChains {
  std::vector<Vec2> points;
  std::vector<SegmentChain> chains;
};

/// Takes segments as patches have them. O(n log n).
SegmentChains chains_of(std::span<const double> segments);

enum class ParabolasAs : std::uint8_t {
  chords,  ///< a segment each, from end to end
  chains,  ///< segments along them (core/base/geometry/parabola_arc.h)
};
/// The segments of a layer, and after them its parabolas in their order. Each segment has the scalar of its instance.
std::vector<double> segments_of(const LayerMirror& mirror, LayerIndex layer, ParabolasAs parabolas);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The chains that the segments of a layer form.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

/// A chain of points by number; of a closed one the first is not repeated.
struct SegmentChain {
  bool closed = false;
  std::vector<std::uint32_t> points;
  std::vector<std::uint32_t> segments;  ///< by number among the instances: segments[i] joins points[i] and the next
};

/// What it guarantees: points are numbered by first appearance; equal ends of segments are one point. Each segment of
/// positive length is in one chain. Chains lead from one point that has not just two segments to the next; what is left
/// then is closed.
struct SegmentChains {
  std::vector<Vec2> points;
  std::vector<SegmentChain> chains;
};

/// Segments as in patches. O(n log n).
SegmentChains chains_of(std::span<const double> segments);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Bounding boxes of blocks of consecutive instances, so that blocks out of view are not drawn. Private to render.
//
// Guarantees: an instance that meets a box is in one of the runs of that box. Boxes only grow until `clear`,
// because old extents are not kept: after many edits all over the plane more is drawn than necessary.
//
// Smallest use:
//     boxes.add(i, box_of_instance(kind, encoded));
//     for (const BlockBoxes::Run run : boxes.runs(count, view)) draw(run.first, run.count);
//
// Cost: `add` O(1), `runs` a comparison for each `kBlock` instances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/draw/primitives.h"

namespace mes::render {

/// The extent of an encoded instance, without the width of strokes and the size of points; empty for an invisible
/// instance, everywhere for an unbounded one.
Box2 box_of_instance(PrimitiveKind kind, std::span<const double> encoded);

class BlockBoxes {
 public:
  /// Rows of structures that were triangulated in one batch lie near each other if their numbers are close.
  static constexpr std::uint32_t kBlock = 2048;

  struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    friend bool operator==(const Run&, const Run&) = default;
  };

  void add(std::size_t instance, const Box2& box);
  void clear() { boxes_.clear(); }
  /// The runs of the first `count` instances whose blocks meet the box, in order. Valid until the next call.
  std::span<const Run> runs(std::uint32_t count, const Box2& view);

 private:
  std::vector<Box2> boxes_;
  std::vector<Run> runs_;
};

}  // namespace mes::render

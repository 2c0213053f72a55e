// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding box of the selection, around which the frame with handles is drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "app/editing/editor.h"
#include "core/base/geometry/box2.h"

namespace mes {

/// Cost: O(1) while neither the selection nor the document changes, else O(rows). Threads: the window's.
class SelectionFrame {
 public:
  explicit SelectionFrame(const Editor& editor) : editor_(editor) {}

  /// The box of the selected samples and centres of balls; nothing with fewer than two different points.
  std::optional<Box2> box() const;

 private:
  const Editor& editor_;
  mutable std::optional<Box2> box_;
  mutable std::pair<std::uint64_t, std::uint64_t> box_of_{~std::uint64_t{0}, 0};  // revisions
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The box around what is selected, as a frame with handles goes around it.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "app/editing/editor.h"
#include "core/base/box2.h"

namespace mes {

/// Cost: O(1) while neither the selection nor the document changes, else O(rows). Threads: the window's.
class SelectionFrame {
 public:
  explicit SelectionFrame(const Editor& editor) : editor_(editor) {}

  /// Around the selected samples and centres of balls; nothing where there are fewer than two different places.
  std::optional<Box2> box() const;

 private:
  const Editor& editor_;
  mutable std::optional<Box2> box_;
  mutable std::pair<std::uint64_t, std::uint64_t> box_of_{~std::uint64_t{0}, 0};  // revisions
};

}  // namespace mes

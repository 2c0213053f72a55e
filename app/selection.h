// SPDX-License-Identifier: GPL-3.0-or-later
// Which samples are selected.
#pragma once

#include <cstdint>
#include <vector>

#include "core/document/document.h"

namespace mes {

/// What it guarantees: only live samples are selected; a removed sample leaves the selection, and comes back
/// unselected when the removal is undone. Cost: O(1) a change, O(rows) for the whole-set operations.
/// Threads: none; it follows the document of the window's thread.
class Selection {
 public:
  bool contains(Slot slot) const { return slot < mask_.size() && mask_[slot] != 0; }
  std::size_t size() const { return count_; }
  bool is_empty() const { return count_ == 0; }
  /// Grows with every change; equal numbers mean an equal selection.
  std::uint64_t revision() const { return revision_; }

  void add(Slot slot);
  void remove(Slot slot);
  void clear();
  void select_all(const Document& document);
  void invert(const Document& document);
  /// Selected rows, increasing. O(rows).
  std::vector<Slot> slots() const;

  /// To be called after `document.apply(delta)`.
  void follow(const DocumentDelta& delta);

 private:
  std::vector<std::uint8_t> mask_;
  std::size_t count_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The last deltas by revision, so that a follower with an older state can catch up.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/delta.h"

namespace mes {

/// Undo and redo append too, so the journal is a timeline: revisions may reappear, and an entry stays until `capacity`
/// newer ones exist.
class Journal {
 public:
  explicit Journal(std::size_t capacity = 4096) : capacity_(capacity) {}

  /// Number of deltas ever appended, which is the position of an up-to-date follower.
  std::uint64_t end() const { return first_ + entries_.size(); }
  void append(std::shared_ptr<const DocumentDelta> delta) {
    entries_.push_back(std::move(delta));
    if (entries_.size() > capacity_) {
      entries_.pop_front();
      ++first_;
    }
  }
  /// Deltas from `position` to the end; nothing if the follower is too far behind and must reload.
  std::optional<std::vector<std::shared_ptr<const DocumentDelta>>> since(std::uint64_t position) const {
    if (position < first_ || position > end()) return std::nullopt;
    return std::vector(entries_.begin() + static_cast<std::ptrdiff_t>(position - first_), entries_.end());
  }

 private:
  std::size_t capacity_;
  std::uint64_t first_ = 0;
  std::deque<std::shared_ptr<const DocumentDelta>> entries_;
};

}  // namespace mes

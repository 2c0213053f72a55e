// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a table differ from the run before.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/slot.h"

namespace mes {

/// `touched` rows are alive now and may differ from before (or are new); `removed` rows were alive and are not any
/// more. Neither list names a row twice. Consumers do work for these rows only.
struct ChangeSet {
  std::vector<Slot> touched;
  std::vector<Slot> removed;

  bool is_empty() const { return touched.empty() && removed.empty(); }
  std::size_t size() const { return touched.size() + removed.size(); }
  void clear() {
    touched.clear();
    removed.clear();
  }
};

/// A set of slots with O(1) insertion and O(1) clearing, for work lists that must not name a row twice.
class SlotMarks {
 public:
  /// Forgets all marks and makes room for slots below `count`.
  void begin(std::size_t count) {
    if (stamp_.size() < count) stamp_.resize(count + count / 4, 0);
    if (++epoch_ == 0) {
      stamp_.assign(stamp_.size(), 0);
      epoch_ = 1;
    }
  }
  /// Makes room for one more slot in the middle of a run.
  void grow(std::size_t count) {
    if (stamp_.size() < count) stamp_.resize(count + count / 4, 0);
  }
  bool contains(Slot slot) const { return slot < stamp_.size() && stamp_[slot] == epoch_; }
  /// True when the slot was not marked before.
  bool insert(Slot slot) {
    if (stamp_[slot] == epoch_) return false;
    stamp_[slot] = epoch_;
    return true;
  }
  void erase(Slot slot) { stamp_[slot] = 0; }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t epoch_ = 0;
};

/// Collects touched rows during an update and sorts them into a `ChangeSet` at its end.
class ChangeRecorder {
 public:
  void begin(std::size_t rows) {
    marks_.begin(rows);
    noted_.clear();
  }
  /// Notes that the row changed, was born or died. `was_alive` counts at the first note of a run only.
  void note(Slot slot, bool was_alive) {
    marks_.grow(slot + std::size_t{1});
    if (marks_.insert(slot)) noted_.push_back({slot, was_alive});
  }
  /// `is_alive(slot)` tells the state after the run. Rows born and gone within it are not mentioned.
  template <class IsAlive>
  void finish(ChangeSet& out, IsAlive is_alive) {
    out.clear();
    for (const Note& note : noted_) {
      if (is_alive(note.slot)) {
        out.touched.push_back(note.slot);
      } else if (note.was_alive) {
        out.removed.push_back(note.slot);
      }
    }
  }

 private:
  struct Note {
    Slot slot;
    bool was_alive;
  };
  SlotMarks marks_;
  std::vector<Note> noted_;
};

}  // namespace mes

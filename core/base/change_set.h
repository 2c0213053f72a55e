// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a table changed since the previous run.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/slot.h"
#include "core/base/table.h"

namespace mes {

/// Changed rows of one table. `touched` rows are alive now and are new or may have changed; `removed` rows were alive
/// before and are not now. Neither list names a row twice. Consumers process only these rows.
template <class Row>
struct ChangeSet {
  std::vector<Row> touched;
  std::vector<Row> removed;

  bool is_empty() const { return touched.empty() && removed.empty(); }
  std::size_t size() const { return touched.size() + removed.size(); }
  void clear() {
    touched.clear();
    removed.clear();
  }
};

/// The change set of a table that never changes, except for rebuilds that make every row new.
template <class Row>
const ChangeSet<Row>& no_changes() {
  static const ChangeSet<Row> none;
  return none;
}

/// A set of slots with O(1) insertion and O(1) clearing, for work lists that must not name a row twice.
template <class Row>
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
  /// Makes room for more slots during a run.
  void grow(std::size_t count) {
    if (stamp_.size() < count) stamp_.resize(count + count / 4, 0);
  }
  bool contains(Row slot) const { return stamp_.has(slot) && stamp_[slot] == epoch_; }
  /// Marks the slot. Returns true if it was not marked before.
  bool insert(Row slot) {
    if (stamp_[slot] == epoch_) return false;
    stamp_[slot] = epoch_;
    return true;
  }
  void erase(Row slot) { stamp_[slot] = 0; }

 private:
  Table<Row, std::uint32_t> stamp_;
  std::uint32_t epoch_ = 0;
};

/// Collects touched rows during an update and sorts them into a `ChangeSet` at its end.
template <class Row>
class ChangeRecorder {
 public:
  void begin(std::size_t rows) {
    marks_.begin(rows);
    noted_.clear();
  }
  /// Records that the row changed, was born or died. Only the first `was_alive` of a run counts.
  void note(Row slot, bool was_alive) {
    marks_.grow(slot.index() + std::size_t{1});
    if (marks_.insert(slot)) noted_.push_back({slot, was_alive});
  }
  /// `is_alive(slot)` is the state after the run. Rows that are born and die within the run are not listed.
  template <class IsAlive>
  void finish(ChangeSet<Row>& out, IsAlive is_alive) {
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
    Row slot;
    bool was_alive;
  };
  SlotMarks<Row> marks_;
  std::vector<Note> noted_;
};

}  // namespace mes

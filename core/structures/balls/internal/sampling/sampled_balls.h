// SPDX-License-Identifier: GPL-3.0-or-later
// A table of disks owned by elements that are added and removed: the rows of an element live as long as it does.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/disk.h"

namespace mes {

/// A row, and an element that owns rows.
using SampledSlot = Slot<struct SampledTag>;
using OwnerSlot = Slot<struct OwnerTag>;

class SampledBalls {
 public:
  std::size_t rows() const { return disks_.size(); }
  bool is_alive(SampledSlot row) const { return disks_[row].radius >= 0.0; }
  const Disk& disk(SampledSlot row) const { return disks_[row]; }
  const Table<SampledSlot, Disk>& disks() const { return disks_; }
  std::size_t count() const { return disks_.size() - free_.size(); }
  /// Calls `visit(row)` for all rows of an owner.
  template <class Visit>
  void for_each_of(OwnerSlot owner, Visit visit) const {
    if (!first_.has(owner)) return;
    for (SampledSlot row = first_[owner]; row != kNoSlot; row = next_[row]) visit(row);
  }
  const ChangeSet<SampledSlot>& changes() const { return changes_; }
  void clear_changes() { changes_.clear(); }

  /// Drops everything, before a rebuild.
  void reset() {
    disks_.clear();
    next_.clear();
    first_.clear();
    free_.clear();
    changes_.clear();
    is_recording_ = false;
  }
  /// Begins an update, which lasts until `finish`.
  void begin() {
    recorder_.begin(disks_.size());
    is_recording_ = true;
  }
  void finish() {
    recorder_.finish(changes_, [this](SampledSlot row) { return is_alive(row); });
  }

  void add(OwnerSlot owner, const Disk& disk) {
    SampledSlot row = disks_.next();
    if (free_.empty()) {
      disks_.push_back({{}, kDead});
      next_.push_back(kNoSlot);
    } else {
      row = free_.back();
      free_.pop_back();
    }
    if (is_recording_) recorder_.note(row, false);
    disks_[row] = disk;
    if (!first_.has(owner)) first_.resize(owner.index() + owner.index() / 4 + std::size_t{1});
    next_[row] = first_[owner];
    first_[owner] = row;
  }
  /// Drops all rows of an owner and returns their number.
  std::size_t drop(OwnerSlot owner) {
    if (!first_.has(owner)) return 0;
    std::size_t dropped = 0;
    for (SampledSlot row = first_[owner]; row != kNoSlot; row = next_[row]) {
      if (is_recording_) recorder_.note(row, true);
      disks_[row].radius = kDead;
      free_.push_back(row);
      ++dropped;
    }
    first_[owner] = kNoSlot;
    return dropped;
  }

 private:
  static constexpr double kDead = -1.0;
  Table<SampledSlot, Disk> disks_;
  Table<SampledSlot, SampledSlot> next_;  // next row of the same owner
  Table<OwnerSlot, SampledSlot> first_;
  std::vector<SampledSlot> free_;
  bool is_recording_ = false;
  ChangeRecorder<SampledSlot> recorder_;
  ChangeSet<SampledSlot> changes_;
};

}  // namespace mes

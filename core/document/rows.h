// SPDX-License-Identifier: GPL-3.0-or-later
// Objects with stable ids in reusable rows: the common part of samples and balls of a document.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/base/slot.h"
#include "core/base/table.h"

namespace mes {

/// Guarantees:
///  1. An id names the same object for the whole session and is never reused, although rows are.
///  2. Free rows form a stack: undoing a change returns rows in the reverse order of taking them, so that redo finds
///     the rows with which it was recorded. A change that does not fit is refused by an assertion.
///
/// Cost: O(1) a change. Threads: none.
template <class Value, class Tag>
class Rows {
 public:
  using ThingId = Id<Tag>;
  using Row = Slot<Tag>;

  std::size_t count() const { return alive_; }
  /// Number of rows, in use or free.
  std::size_t row_count() const { return id_.size(); }
  bool is_alive(Row slot) const { return id_.has(slot) && id_[slot].is_valid(); }
  const Value& value(Row slot) const { return value_[slot]; }
  ThingId id(Row slot) const { return id_[slot]; }
  /// Dead rows hold a default value and an invalid id.
  const Table<Row, Value>& values() const { return value_; }
  const Table<Row, ThingId>& ids() const { return id_; }
  const std::vector<Row>& free_slots() const { return free_; }
  std::uint32_t next_id() const { return next_id_; }
  /// Id of the first object after the last replacement, whether it exists already or not.
  std::uint32_t first_id() const { return first_id_; }
  /// Starts ids here, because lower ones are taken. Only while the table is empty.
  void number_from(std::uint32_t id) {
    MES_ASSERT(id_.empty());
    first_id_ = next_id_ = id;
  }
  /// The row of the i-th of several insertions.
  Row slot_for_new(std::size_t i) const {
    return i < free_.size() ? free_[free_.size() - 1 - i] : Row(id_.size() + i - free_.size());
  }
  Row slot_of(ThingId id) const {
    const std::uint32_t number = id.value - first_id_;
    return id.value >= first_id_ && number < slot_of_.size() ? slot_of_[number] : kNoSlot;
  }
  /// Live rows by increasing id. O(n log n).
  std::vector<Row> by_age() const {
    std::vector<Row> slots;
    slots.reserve(alive_);
    for (const Row slot : id_.rows())
      if (id_[slot].is_valid()) slots.push_back(slot);
    std::ranges::sort(slots, {}, [this](Row slot) { return id_[slot]; });
    return slots;
  }

  /// Reserves memory, so that `inserted` insertions with ids up to `last`, and `removed` removals, allocate nothing.
  void make_room(std::size_t inserted, ThingId last, std::size_t removed) {
    const auto grow = [](auto& column, std::size_t size) {
      if (column.capacity() < size) column.reserve(std::max(size, column.capacity() + column.capacity() / 2));
    };
    if (inserted != 0) {
      grow(value_, value_.size() + inserted);
      grow(id_, id_.size() + inserted);
      grow(slot_of_, last.value - first_id_ + std::size_t{1});
    }
    grow(free_, free_.size() + removed);
  }
  void insert(Row slot, ThingId id, const Value& value) {
    if (!free_.empty() && free_.back() == slot) {
      free_.pop_back();
    } else {
      MES_ASSERT(slot == id_.next());
      value_.emplace_back();
      id_.emplace_back();
    }
    value_[slot] = value;
    id_[slot] = id;
    set_slot(id, slot);
    next_id_ = std::max(next_id_, id.value + 1);
    ++alive_;
  }
  void remove(Row slot, ThingId id) {
    MES_ASSERT(is_alive(slot) && id_[slot] == id);
    set_slot(id, kNoSlot);
    id_[slot] = ThingId{};
    value_[slot] = Value{};
    free_.push_back(slot);
    --alive_;
  }
  void set(Row slot, ThingId id, const Value& value) {
    MES_ASSERT(is_alive(slot) && id_[slot] == id);
    value_[slot] = value;
  }
  /// A table with other rows, whose ids continue from this one.
  Rows replaced_by(Table<Row, Value> values, Table<Row, ThingId> ids, std::vector<Row> free_slots,
                   ThingId first) const {
    Rows out;
    out.next_id_ = next_id_;
    out.take(std::move(values), std::move(ids), std::move(free_slots), first);
    return out;
  }

 private:
  void take(Table<Row, Value> values, Table<Row, ThingId> ids, std::vector<Row> free_slots, ThingId first) {
    MES_ASSERT(values.size() == ids.size());
    first_id_ = first.value;
    value_ = std::move(values);
    id_ = std::move(ids);
    free_ = std::move(free_slots);
    next_id_ = std::max(next_id_, first_id_);
    for (const Row slot : id_.rows()) {
      if (!id_[slot].is_valid()) continue;
      set_slot(id_[slot], slot);
      next_id_ = std::max(next_id_, id_[slot].value + 1);
      ++alive_;
    }
  }
  void set_slot(ThingId id, Row slot) {
    MES_ASSERT(id.value >= first_id_);
    const std::size_t number = id.value - first_id_;
    if (number >= slot_of_.size()) slot_of_.resize(number + 1, kNoSlot);
    slot_of_[number] = slot;
  }

  Table<Row, Value> value_;
  Table<Row, ThingId> id_;
  std::vector<Row> free_;
  std::vector<Row> slot_of_;  // indexed by id, relative to the first
  std::size_t alive_ = 0;
  std::uint32_t first_id_ = 0;
  std::uint32_t next_id_ = 0;
};

}  // namespace mes

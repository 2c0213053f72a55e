// SPDX-License-Identifier: GPL-3.0-or-later
// A column of values that only the slots of its rows can index.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/slot.h"

namespace mes {

/// A `std::vector` whose index is a `Row`.
///
/// Smallest use:
///     Table<EdgeSlot, double> length;
///     const EdgeSlot edge = length.next();
///     length.push_back(1.0);
///     length[edge] *= 2.0;
///
/// Cost: none beyond `std::vector`. Threads: as for `std::vector`.
template <class Row, class Value>
class Table : private std::vector<Value> {
  using Base = std::vector<Value>;

 public:
  using typename Base::value_type;

  Table() = default;
  explicit Table(std::size_t rows, const Value& value = Value()) : Base(rows, value) {}

  decltype(auto) operator[](Row row) { return Base::operator[](row.index()); }
  decltype(auto) operator[](Row row) const { return Base::operator[](row.index()); }
  bool has(Row row) const { return row.index() < Base::size(); }
  /// The row that the next `push_back` will create.
  Row next() const { return Row(Base::size()); }
  /// All rows that exist at the time of the call.
  SlotRange<Row> rows() const { return slots_below<Row>(Base::size()); }
  /// Address of the row, for `prefetch`; the row need not exist.
  const Value* address(Row row) const { return Base::data() + row.index(); }

  // Values, in the order of the rows.
  using Base::assign;
  using Base::back;
  using Base::begin;
  using Base::capacity;
  using Base::clear;
  using Base::emplace_back;
  using Base::empty;
  using Base::end;
  using Base::pop_back;
  using Base::push_back;
  using Base::reserve;
  using Base::resize;
  using Base::shrink_to_fit;
  using Base::size;
  const Base& values() const { return *this; }
  Base& values() { return *this; }
  void swap(Table& other) { Base::swap(other); }

  friend bool operator==(const Table& a, const Table& b) { return a.values() == b.values(); }
};

/// A read-only view of a table that belongs to someone else.
template <class Row, class Value>
class TableView {
 public:
  TableView() = default;
  TableView(const Table<Row, Value>& table) : values_(table.values()) {}  // NOLINT(google-explicit-constructor)

  const Value& operator[](Row row) const { return values_[row.index()]; }
  SlotRange<Row> rows() const { return slots_below<Row>(values_.size()); }
  std::size_t size() const { return values_.size(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::span<const Value> values_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Typed row indices of tables, one type for each table.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/ids.h"

namespace mes {

/// Converts to a slot of any type that names no row.
enum class NoSlot : std::uint8_t { none };
inline constexpr NoSlot kNoSlot = NoSlot::none;

/// Row of one table, or of several tables whose rows describe the same elements. Stable while the element lives; rows
/// of dead elements are reused.
///
/// Guarantees: slots of different tables do not convert to each other, and numbers and slots convert only
/// explicitly. Takes four bytes, names no row by default, and is as cheap as the number.
///
/// Smallest use:
///     using CornerSlot = Slot<struct CornerTag>;
///     Table<CornerSlot, double> angle(count);
///     for (const CornerSlot corner : angle.rows()) angle[corner] = 60.0;
template <class Tag>
class Slot {
 public:
  constexpr Slot() = default;
  constexpr Slot(NoSlot) {}  // NOLINT(google-explicit-constructor): "none" is one word for all tables
  constexpr explicit Slot(std::size_t index) : index_(static_cast<std::uint32_t>(index)) {}

  constexpr RowNumber index() const { return index_; }
  /// The next row.
  constexpr Slot& operator++() {
    ++index_;
    return *this;
  }
  /// Ordered by index; "no row" is last.
  friend constexpr auto operator<=>(Slot, Slot) = default;

 private:
  std::uint32_t index_ = 0xffffffffU;
};

/// The row of one table that corresponds to the row `from` of another, where a table states that it has the same rows
/// as the other. "No row" stays "no row".
template <class To, class From>
constexpr To same_row(Slot<From> from) {
  return To(from.index());
}

/// The rows below a count, in order.
template <class Row>
class SlotRange {
 public:
  class Iterator {
   public:
    using value_type = Row;
    using difference_type = std::ptrdiff_t;
    constexpr Iterator() = default;
    constexpr explicit Iterator(Row at) : at_(at) {}
    constexpr Row operator*() const { return at_; }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++at_;
      return before;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    Row at_;
  };
  constexpr explicit SlotRange(std::size_t count) : end_(count) {}
  constexpr SlotRange(std::size_t begin, std::size_t end) : begin_(begin), end_(end) {}
  constexpr Iterator begin() const { return Iterator(begin_); }
  constexpr Iterator end() const { return Iterator(end_); }

 private:
  Row begin_{0};
  Row end_;
};

/// Rows below a count, as in `for (const FaceSlot face : slots_below<FaceSlot>(count))`.
template <class Row>
constexpr SlotRange<Row> slots_below(std::size_t count) {
  return SlotRange<Row>(count);
}
/// Rows from `begin` to before `end`, as `parallel_for` hands them out.
template <class Row>
constexpr SlotRange<Row> slots_between(std::size_t begin, std::size_t end) {
  return SlotRange<Row>(begin, end);
}

/// Rows of the tables of samples and balls of a document.
using SampleSlot = Slot<SampleTag>;
using BallSlot = Slot<BallTag>;

}  // namespace mes

template <class Tag>
struct std::hash<mes::Slot<Tag>> {
  std::size_t operator()(mes::Slot<Tag> slot) const noexcept { return std::hash<std::uint32_t>{}(slot.index()); }
};

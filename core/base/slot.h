// SPDX-License-Identifier: GPL-3.0-or-later
// Row numbers of tables, each kind a type of its own, and identifiers that are never used twice.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace mes {

/// Number of a row whose table the type does not say: where rows of all kinds go the same way, as in drawing and in
/// questions about what lies at a place. `Slot::index` and the constructor of `Slot` are the way there and back.
using RowNumber = std::uint32_t;

/// Converts into the slot of any kind that names no row.
enum class NoSlot : std::uint8_t { none };
inline constexpr NoSlot kNoSlot = NoSlot::none;

/// Row of one table, or of tables whose rows are about the same things. Stable while the element lives; rows of dead
/// elements are used again.
///
/// What it guarantees: slots of different tables do not convert into each other, nor do numbers into slots or slots
/// into numbers without being asked. Four bytes, no row unless given one; as cheap as the number.
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
  /// By number; no row comes last.
  friend constexpr auto operator<=>(Slot, Slot) = default;

 private:
  std::uint32_t index_ = 0xffffffffU;
};

/// The row of one table that is the row `from` of another, where a table says that its rows are those of the other.
/// What names no row goes on doing so.
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

/// As in `for (const FaceSlot face : slots_below<FaceSlot>(count))`.
template <class Row>
constexpr SlotRange<Row> slots_below(std::size_t count) {
  return SlotRange<Row>(count);
}
/// Those from `begin` to before `end`, as `parallel_for` hands them out.
template <class Row>
constexpr SlotRange<Row> slots_between(std::size_t begin, std::size_t end) {
  return SlotRange<Row>(begin, end);
}

/// Strong identifier, never reused within a session. `Id<A>` and `Id<B>` do not mix.
template <class Tag>
struct Id {
  std::uint32_t value = 0xffffffffU;
  bool is_valid() const { return value != 0xffffffffU; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

/// Samples and balls of a document, and their rows there.
using SampleId = Id<struct SampleTag>;
using BallId = Id<struct BallTag>;
using SampleSlot = Slot<SampleTag>;
using BallSlot = Slot<BallTag>;

/// Position of a layer in a registry (core/graph/registry.h).
using LayerIndex = std::uint32_t;
inline constexpr LayerIndex kNoLayer = 0xffffffffU;

}  // namespace mes

template <class Tag>
struct std::hash<mes::Id<Tag>> {
  std::size_t operator()(mes::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};

template <class Tag>
struct std::hash<mes::Slot<Tag>> {
  std::size_t operator()(mes::Slot<Tag> slot) const noexcept { return std::hash<std::uint32_t>{}(slot.index()); }
};

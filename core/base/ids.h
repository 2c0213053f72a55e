// SPDX-License-Identifier: GPL-3.0-or-later
// Identifiers that are never reused, and numbers of rows and of layers, for code that does not read tables.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace mes {

/// Index of a row in a table that the type does not name. Used where rows of all tables are treated alike, as in
/// drawing and picking. `Slot::index` and the constructor of `Slot` (slot.h) convert between the two.
using RowNumber = std::uint32_t;

/// Strong identifier, never reused within a session. `Id<A>` and `Id<B>` do not mix.
template <class Tag>
struct Id {
  std::uint32_t value = 0xffffffffU;
  bool is_valid() const { return value != 0xffffffffU; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

/// Samples and balls of a document.
using SampleId = Id<struct SampleTag>;
using BallId = Id<struct BallTag>;

/// Position of a layer in a registry (core/graph/registry.h).
using LayerIndex = std::uint32_t;
inline constexpr LayerIndex kNoLayer = 0xffffffffU;

}  // namespace mes

template <class Tag>
struct std::hash<mes::Id<Tag>> {
  std::size_t operator()(mes::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};

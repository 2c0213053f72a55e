// SPDX-License-Identifier: GPL-3.0-or-later
// Row numbers of tables, and identifiers that are never used twice.
#pragma once

#include <cstdint>
#include <functional>

namespace mes {

/// Row of a table. Stable while the element lives; rows of dead elements are used again.
using Slot = std::uint32_t;
inline constexpr Slot kNoSlot = 0xffffffffU;

/// Strong identifier, never reused within a session. `Id<A>` and `Id<B>` do not mix.
template <class Tag>
struct Id {
  std::uint32_t value = 0xffffffffU;
  bool is_valid() const { return value != 0xffffffffU; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using SampleId = Id<struct SampleTag>;
using BallId = Id<struct BallTag>;

/// Position of a layer in the registry (`layer_descriptors()`).
using LayerIndex = std::uint32_t;

}  // namespace mes

template <class Tag>
struct std::hash<mes::Id<Tag>> {
  std::size_t operator()(mes::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds positions in a list that equal an earlier one. Private to core/curves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// The two zeros are equal; positions that are not finite equal nothing. Cost: linear, expected; about 8 bytes for each
/// position, kept for the next list.
class RepeatedPositions {
 public:
  /// Indices of repeated positions, increasing; valid until the next call. Accepts at most 2^32 - 1 positions.
  std::span<const std::uint32_t> find(std::span<const Vec2> positions);
  /// Whether all positions of all calls were finite.
  bool were_finite() const { return were_finite_; }

 private:
  void find_among_few(std::span<const Vec2> positions);
  void find_among(std::span<const Vec2> positions, std::span<const std::uint32_t> numbers);
  void note_shared_hashes(std::span<const Vec2> positions);

  std::vector<std::uint64_t> once_;
  std::vector<std::uint64_t> twice_;
  std::vector<std::uint32_t> shared_;
  std::vector<std::uint32_t> places_;
  std::vector<std::uint16_t> few_places_;
  std::vector<std::uint32_t> repeated_;
  bool were_finite_ = true;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of outlines, each outline once. Private to core/structures/outline.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

/// The pieces that are no points. A closed curve that goes around several times in the same way has those of one time.
std::vector<Piece> outline_pieces_of(const PlaneCurve& curve);

/// Whether two closed curves are the same in the same direction, wherever they begin.
bool go_around_alike(std::span<const Piece> a, std::span<const Piece> b);

/// A number of a closed curve that does not depend on where it begins.
std::uint64_t fingerprint(std::span<const Piece> pieces);

/// Calls `use(curve, pieces)` for each curve that has pieces, except closed ones that repeat another one. Returns how
/// many these were.
std::size_t for_each_outline(std::span<const PlaneCurve> curves, auto use) {
  std::unordered_map<std::uint64_t, std::vector<const PlaneCurve*>> alike;
  std::size_t repeats = 0;
  for (const PlaneCurve& curve : curves) {
    const std::vector<Piece> pieces = outline_pieces_of(curve);
    if (pieces.empty()) continue;
    if (curve.is_closed()) {
      std::vector<const PlaneCurve*>& others = alike[fingerprint(pieces)];
      const auto is_repeat = [&](const PlaneCurve* other) {
        return go_around_alike(pieces, outline_pieces_of(*other));
      };
      if (std::ranges::any_of(others, is_repeat)) {
        ++repeats;
        continue;
      }
      others.push_back(&curve);
    }
    use(curve, pieces);
  }
  return repeats;
}

}  // namespace mes

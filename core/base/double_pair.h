// SPDX-License-Identifier: GPL-3.0-or-later
// Two doubles that a processor computes with at once.
#pragma once

namespace mes {

using DoublePair = double __attribute__((vector_size(2 * sizeof(double))));
/// The result of a comparison of two pairs: all bits of an element are set where it holds.
using DoublePairMask = decltype(DoublePair{} < DoublePair{});

inline bool is_any_set(DoublePairMask mask) {
  return (mask[0] | mask[1]) != 0;
}

}  // namespace mes

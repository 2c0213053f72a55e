// SPDX-License-Identifier: GPL-3.0-or-later
// Two doubles that the processor handles in one instruction.
#pragma once

namespace mes {

using DoublePair = double __attribute__((vector_size(2 * sizeof(double))));
/// The result of comparing two pairs: all bits of an element are set where the comparison holds.
using DoublePairMask = decltype(DoublePair{} < DoublePair{});

inline bool is_any_set(DoublePairMask mask) {
  return (mask[0] | mask[1]) != 0;
}

}  // namespace mes

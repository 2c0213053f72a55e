// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/document/document.h"

namespace mes::test {

/// Positions of the samples in input order.
inline std::vector<Vec2> positions_of(const Document& document) {
  std::vector<Vec2> out;
  for (const SampleSlot slot : document.slots_in_input_order()) out.push_back(document.position(slot));
  return out;
}

}  // namespace mes::test

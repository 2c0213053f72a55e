// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/axis_pruning.h"

namespace mes {

void AxisPruning::clear() {
  items_.clear();
  end_.clear();
  is_root_.clear();
  level_.clear();
  is_gone_.clear();
}

void AxisPruning::begin(std::size_t edge_rows, std::size_t node_rows) {
  items_.clear();
  end_.assign(node_rows, {});
  is_root_.assign(node_rows, 0);
  level_.assign(edge_rows, kNoSlot);
}

void AxisPruning::add(EdgeSlot edge, FaceSlot a, FaceSlot b) {
  const auto position = static_cast<std::uint32_t>(items_.size());
  items_.push_back({edge, {a, b}});
  for (const FaceSlot node : {a, b}) {
    End& end = end_[node];
    ++end.degree;
    ++end.degree_at_first;
    end.items ^= position;
  }
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/scalar_store.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

namespace mes::render {
namespace {

constexpr std::size_t kBlock = 32;

std::size_t blocks_of(std::size_t size) {
  return (size + kBlock - 1) / kBlock;
}

}  // namespace

void ScalarStore::clear() {
  values_.clear();
  levels_.clear();
  changed_.clear();
}

void ScalarStore::mark(std::size_t block) {
  if (changed_.empty() || changed_.back() != block) changed_.push_back(block);
}

void ScalarStore::resize(std::size_t size) {
  if (size == values_.size()) return;
  // The block with the end of the smaller size changes; later blocks appear or disappear as a whole.
  for (std::size_t block = std::min(size, values_.size()) / kBlock; block < blocks_of(size); ++block) mark(block);
  values_.resize(size, std::numeric_limits<double>::quiet_NaN());
  std::size_t level = 0;
  for (std::size_t blocks = blocks_of(size); blocks > 0; blocks = blocks == 1 ? 0 : blocks_of(blocks)) {
    if (levels_.size() <= level) levels_.emplace_back();
    std::vector<ScalarRange>& ranges = levels_[level];
    // A level of changed length recomputes its last block from the blocks below, down to the values.
    if (ranges.size() != blocks) mark(blocks_of(size) - 1);
    ranges.resize(blocks);
    ++level;
  }
  levels_.resize(level);
}

void ScalarStore::set(std::size_t index, double value) {
  MES_ASSERT(index < values_.size());
  values_[index] = value;
  mark(index / kBlock);
}

ScalarRange ScalarStore::of_block(std::size_t level, std::size_t block) const {
  ScalarRange out;
  const std::size_t first = block * kBlock;
  if (level == 0) {
    const std::size_t end = std::min(first + kBlock, values_.size());
    for (std::size_t i = first; i < end; ++i) out.add(values_[i]);
  } else {
    const std::vector<ScalarRange>& below = levels_[level - 1];
    const std::size_t end = std::min(first + kBlock, below.size());
    for (std::size_t i = first; i < end; ++i) out.add(below[i]);
  }
  return out;
}

void ScalarStore::settle() {
  std::vector<std::size_t> blocks = std::move(changed_);
  changed_.clear();
  if (!std::ranges::is_sorted(blocks)) std::ranges::sort(blocks);
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    for (std::size_t& block : blocks) {
      if (block < levels_[level].size()) levels_[level][block] = of_block(level, block);
      block /= kBlock;
    }
  }
}

}  // namespace mes::render

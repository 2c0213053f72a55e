// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts items by 64-bit keys in linear time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mes {

struct RadixKey {
  std::uint64_t key = 0;
  std::uint32_t item = 0;
};

/// Sorts in ascending order of the keys; items with equal keys keep their order.
///
/// Cost: O(n) for each of six digits that is not the same in all keys; faster than comparison sorts from some thousand
/// items on. Needs memory for a second copy of the items.
///
/// Smallest use:
///     std::vector<RadixKey> keys{{7, 0}, {3, 1}};
///     radix_sort(keys);  // item 1, then item 0
inline void radix_sort(std::vector<RadixKey>& keys) {
  constexpr unsigned kBits = 11;
  constexpr unsigned kDigits = 6;
  constexpr std::size_t kValues = std::size_t{1} << kBits;
  std::vector<std::array<std::uint32_t, kValues>> counts(kDigits);
  for (auto& count : counts) count.fill(0);
  const auto digit_of = [](std::uint64_t key, unsigned digit) { return (key >> (digit * kBits)) & (kValues - 1); };
  for (const RadixKey& key : keys)
    for (unsigned digit = 0; digit < kDigits; ++digit) ++counts[digit][digit_of(key.key, digit)];
  std::vector<RadixKey> other(keys.size());
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    auto& count = counts[digit];
    if (keys.empty() || count[digit_of(keys.front().key, digit)] == keys.size()) continue;
    std::uint32_t first = 0;
    for (std::uint32_t& at : count) {
      const std::uint32_t here = at;
      at = first;
      first += here;
    }
    for (const RadixKey& key : keys) other[count[digit_of(key.key, digit)]++] = key;
    keys.swap(other);
  }
}

}  // namespace mes

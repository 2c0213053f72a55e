// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/driver/coverage.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace {

constexpr std::size_t kCounters = std::size_t{1} << 17U;
std::uint8_t counters[kCounters];
thread_local std::uintptr_t block_before = 0;
std::uint64_t entered = 0;  // threads may lose each other's counts

}  // namespace

extern "C" void __sanitizer_cov_trace_pc();
extern "C" void __sanitizer_cov_trace_pc() {
  // Relative to this function, so that the place of the program in memory does not matter.
  const auto here = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0)) -
                    reinterpret_cast<std::uintptr_t>(&__sanitizer_cov_trace_pc);
  const std::uintptr_t block = (here * 0x9e3779b97f4a7c15U) >> 40U;
  std::uint8_t& counter = counters[(block ^ block_before) % kCounters];
  if (counter != 255) ++counter;
  block_before = block >> 1U;
  ++entered;
}

namespace mes::fuzz {
namespace {

/// 1, 2, 3, 4-7, 8-15, 16-31, 32-127 and more each have a bit.
std::uint8_t magnitude_bit(std::uint8_t count) {
  if (count <= 3) return static_cast<std::uint8_t>(1U << (count - 1U));
  if (count <= 31) return static_cast<std::uint8_t>(1U << static_cast<unsigned>(std::bit_width(count)));
  return count <= 127 ? std::uint8_t{64} : std::uint8_t{128};
}

}  // namespace

void begin_counting() {
  std::memset(counters, 0, sizeof counters);
  block_before = 0;
  entered = 0;
}

std::uint64_t blocks_entered() {
  return entered;
}

Reached::Reached() : seen_(kCounters, 0) {}

std::size_t Reached::add_run() {
  std::size_t added = 0;
  for (std::size_t begin = 0; begin < kCounters; begin += sizeof(std::uint64_t)) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, counters + begin, sizeof eight);
    if (eight == 0) continue;
    for (std::size_t i = begin; i < begin + sizeof eight; ++i) {
      if (counters[i] == 0) continue;
      const std::uint8_t bit = magnitude_bit(counters[i]);
      if ((seen_[i] & bit) != 0) continue;
      seen_[i] |= bit;
      ++added;
    }
  }
  return added;
}

std::size_t Reached::edges() const {
  return seen_.size() - static_cast<std::size_t>(std::ranges::count(seen_, std::uint8_t{0}));
}

}  // namespace mes::fuzz

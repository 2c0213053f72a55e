// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine and in every build.
//
// Guarantees:
//  1. Number i of a seed is a pure function of (seed, i), independent of call order, threads and platform.
//  2. `uniform()` is a multiple of 2^-53 in [0, 1), made with integer arithmetic and one exact multiplication.
//  3. Different seeds, even consecutive ones, give unrelated sequences.
//
// Smallest use:
//     Rng random(seed);
//     double x = random.uniform(-1.0, 1.0);
//
// Cost: a few nanoseconds for each number, 16 bytes of state. Threads: a value type; give each thread its own.
//
// Inside: SplitMix64, which mixes a Weyl sequence (the counter times an odd constant) with a 64-bit finaliser.
// Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014; the seed is mixed once
// before use, so that seeds 1, 2, 3 do not walk the same Weyl sequence a few steps apart. Not for secrets.
#pragma once

#include <cstdint>

namespace mes {

class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : base_(mix(seed + kStep)) {}

  /// Number `i` of the sequence, without moving the counter.
  constexpr std::uint64_t at(std::uint64_t i) const { return mix(base_ + (i + 1) * kStep); }
  constexpr std::uint64_t next() { return at(counter_++); }
  /// A number in [0, 1).
  constexpr double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  /// A number in [low, high), up to the rounding of the last step.
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// An integer from 0 to count - 1; `count` must be above 0. The bias is below count * 2^-64.
  constexpr std::uint64_t below(std::uint64_t count) {
    // High word of a 64 x 64 product, from 32-bit halves: no compiler extension needed.
    const std::uint64_t x = next();
    const std::uint64_t x_high = x >> 32U;
    const std::uint64_t x_low = x & 0xffffffffU;
    const std::uint64_t c_high = count >> 32U;
    const std::uint64_t c_low = count & 0xffffffffU;
    const std::uint64_t middle = x_high * c_low + ((x_low * c_low) >> 32U);
    const std::uint64_t other = x_low * c_high + (middle & 0xffffffffU);
    return x_high * c_high + (middle >> 32U) + (other >> 32U);
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  std::uint64_t base_;
  std::uint64_t counter_ = 0;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions store seeds, so the numbers generated from a seed are a file format.
#include <catch2/catch.hpp>
#include <vector>

#include "core/base/rng.h"

using mes::Rng;

TEST_CASE("number i is a function of seed and i alone") {
  Rng random(42);
  std::vector<std::uint64_t> drawn;
  for (int i = 0; i < 100; ++i) drawn.push_back(random.next());
  const Rng again(42);
  for (std::uint64_t i = 100; i-- > 0;) CHECK(again.at(i) == drawn[i]);
  CHECK(Rng(43).at(0) != drawn[0]);
  CHECK(Rng(43).at(0) != drawn[1]);
}

TEST_CASE("the first numbers of seed 1 are the ones of the first release") {
  Rng random(1);
  CHECK(random.next() == 0x5e41ab087439611eU);
  CHECK(random.at(1) == 0xf18d6ce93d6cf1eeU);
  CHECK(random.at(1000) == 0xcd60691d743dac6cU);
}

TEST_CASE("uniform numbers fill [0, 1) evenly") {
  Rng random(5);
  std::vector<int> bins(16, 0);
  double sum = 0.0;
  for (int i = 0; i < 160000; ++i) {
    const double x = random.uniform();
    REQUIRE(x >= 0.0);
    REQUIRE(x < 1.0);
    sum += x;
    ++bins[static_cast<std::size_t>(x * 16.0)];
  }
  // The standard deviation is 97 for a bin of 10000, and 0.0007 for the mean; six of them are allowed.
  for (const int count : bins) CHECK(std::abs(count - 10000) < 600);
  CHECK(sum / 160000.0 == Approx(0.5).margin(0.0045));
}

TEST_CASE("below(count) reaches every number and none beyond") {
  Rng random(6);
  std::vector<int> seen(7, 0);
  for (int i = 0; i < 700; ++i) {
    const std::uint64_t x = random.below(7);
    REQUIRE(x < 7);
    ++seen[x];
  }
  for (const int count : seen) CHECK(count > 50);
  for (int i = 0; i < 100; ++i) CHECK(random.below(0xffffffffffffffffU) < 0xffffffffffffffffU);
  bool is_large = false;
  for (int i = 0; i < 100; ++i) is_large = is_large || random.below(0xffffffffffffffffU) > (1ULL << 63U);
  CHECK(is_large);
}

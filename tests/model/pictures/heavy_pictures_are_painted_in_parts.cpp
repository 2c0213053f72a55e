// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/picture/detail.h"

using namespace mes;

namespace {

// A graphics card that takes so long for a disk.
double cost(std::uint32_t disks, std::uint32_t every, double ms_per_disk) {
  return ms_per_disk * (disks / every);
}

}  // namespace

TEST_CASE("a light drawing is painted whole from the first frame") {
  Detail detail;
  for (int i = 0; i < 5; ++i) {
    CHECK(detail.begin_changed(2000) == 1);
    detail.painted(cost(2000, 1, 0.001));
    CHECK_FALSE(detail.is_refining());
  }
}

TEST_CASE("a million disks of which nothing is known do not stop the window") {
  Detail detail;
  const std::uint32_t every = detail.begin_changed(1'000'000);
  CHECK(1'000'000 / every <= 512);
  CHECK(1'000'000 / every >= 200);
}

TEST_CASE("on a fast card a picture at rest ends up whole") {
  Detail detail;
  const double ms_per_disk = 0.0001;
  std::uint32_t every = detail.begin_changed(1'000'000);
  detail.painted(cost(1'000'000, every, ms_per_disk));
  int frames = 0;
  while (detail.is_refining()) {
    every = detail.begin_refinement();
    detail.painted(cost(1'000'000, every, ms_per_disk));
    REQUIRE(++frames < 30);
  }
  CHECK(detail.every() == 1);
}

TEST_CASE("on a slow card it stops in time, and moving pictures stay quick") {
  for (const double ms_per_disk : {0.01, 0.1, 0.5}) {
    CAPTURE(ms_per_disk);
    Detail detail;
    const std::uint32_t disks = 200'000;
    for (int round = 0; round < 3; ++round) {
      for (int i = 0; i < 12; ++i) {
        const std::uint32_t every = detail.begin_changed(disks);
        detail.painted(cost(disks, every, ms_per_disk));
      }
      const double moving = cost(disks, detail.every(), ms_per_disk);
      CHECK((moving < 120.0 || disks / detail.every() < 512));
      double last = 0.0;
      int frames = 0;
      while (detail.is_refining()) {
        last = cost(disks, detail.begin_refinement(), ms_per_disk);
        detail.painted(last);
        REQUIRE(++frames < 30);
      }
      CHECK(last <= 300.0);
      // What was affordable at rest is not what a moving picture gets.
      CHECK(cost(disks, detail.begin_changed(disks), ms_per_disk) <= moving + 1e-9);
      detail.painted(cost(disks, detail.every(), ms_per_disk));
    }
  }
}

TEST_CASE("a frame that was long for other reasons does not end refinement") {
  Detail detail;
  const double ms_per_disk = 0.001;
  const std::uint32_t disks = 20'000;
  detail.begin_changed(disks);
  detail.painted(1000.0);
  int frames = 0;
  while (detail.is_refining()) {
    const double own = cost(disks, detail.begin_refinement(), ms_per_disk);
    // Every other frame waits for other programs.
    detail.painted(++frames % 2 == 0 ? own : own + 400.0);
    REQUIRE(frames < 60);
  }
  CHECK(detail.every() == 1);
}

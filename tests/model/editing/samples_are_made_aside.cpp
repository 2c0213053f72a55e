// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialogs of shapes and texts wish for, on a thread of its own.
#include <catch2/catch.hpp>
#include <new>
#include <semaphore>

#include "app/editing/curves/sample_making.h"

using namespace mes;

namespace {

SampleMaking::Made samples(std::size_t count) {
  return {.data = SampleData{.positions = std::vector<Vec2>(count, Vec2{1, 2})}};
}

struct MakingBench {
  std::counting_semaphore<> woken{0};
  SampleMaking making{[this] { woken.release(); }};
  void next() {
    woken.acquire();
    making.follow();
  }
};

}  // namespace

TEST_CASE("of several wishes the last counts, and what is accepted waits for it") {
  std::binary_semaphore may_end{0};
  MakingBench desk;
  CHECK_FALSE(desk.making.is_possible());
  desk.making.want([&](JobControl&) {
    may_end.acquire();
    return samples(1);
  });
  CHECK(desk.making.is_busy());
  desk.making.want([](JobControl&) { return samples(2); });
  desk.making.want([](JobControl&) { return samples(3); });
  desk.making.accept();
  desk.making.follow();
  CHECK(desk.making.made() == nullptr);
  CHECK_FALSE(desk.making.is_accepted_and_ready());
  may_end.release();
  desk.next();
  // The first is shown, and not taken: another one is wished for.
  REQUIRE(desk.making.made() != nullptr);
  CHECK(desk.making.made()->data->positions.size() == 1);
  CHECK_FALSE(desk.making.is_accepted_and_ready());
  desk.next();
  CHECK(desk.making.made()->data->positions.size() == 3);
  CHECK(desk.making.is_accepted_and_ready());
  CHECK_FALSE(desk.making.is_busy());
}

TEST_CASE("what cannot be made says why, and is not taken") {
  MakingBench desk;
  desk.making.want([](JobControl&) -> SampleMaking::Made { throw std::bad_alloc(); });
  desk.making.accept();
  desk.next();
  REQUIRE(desk.making.made() != nullptr);
  REQUIRE_FALSE(desk.making.made()->data);
  CHECK(desk.making.made()->data.error().code == ErrorCode::out_of_memory);
  CHECK_FALSE(desk.making.is_possible());
  CHECK_FALSE(desk.making.is_accepted());
  desk.making.want([](JobControl&) { return samples(2); });
  CHECK(desk.making.is_possible());
  desk.next();
  CHECK_FALSE(desk.making.is_accepted_and_ready());
}

TEST_CASE("what was given up is not delivered") {
  std::binary_semaphore may_end{0};
  MakingBench desk;
  desk.making.want([&](JobControl&) {
    may_end.acquire();
    return samples(1);
  });
  desk.making.accept();
  desk.making.stop();
  may_end.release();
  desk.next();
  CHECK(desk.making.made() == nullptr);
  CHECK_FALSE(desk.making.is_busy());
  CHECK_FALSE(desk.making.is_accepted());
}

TEST_CASE("what was given up ends at its next look") {
  std::binary_semaphore has_begun{0};
  MakingBench desk;
  desk.making.want([&](JobControl& job) {
    has_begun.release();
    // Without the stop this has no end.
    while (true) job.checkpoint();
    return samples(1);
  });
  has_begun.acquire();
  desk.making.stop();
  CHECK_FALSE(desk.making.is_busy());
  desk.woken.acquire();
  desk.making.follow();
  CHECK(desk.making.made() == nullptr);
}

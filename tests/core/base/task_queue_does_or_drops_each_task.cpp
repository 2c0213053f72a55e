// SPDX-License-Identifier: GPL-3.0-or-later
// The queue of tasks for the other cores: each is done once before `finish` returns, and none begins after `drop`.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>

#include "core/base/jobs/task_queue.h"

using namespace mes;

TEST_CASE("every task is done once, by whichever thread") {
  for (int round = 0; round < 200; ++round) {
    std::vector<int> done(50, 0);
    TaskQueue tasks;
    for (int& times : done) tasks.add([&times] { ++times; });
    tasks.finish();
    CHECK(std::ranges::count(done, 1) == 50);
    // It can be used again.
    tasks.add([&done] { ++done[0]; });
    tasks.finish();
    CHECK(done[0] == 2);
  }
}

TEST_CASE("what has not begun can be dropped") {
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> begun = 0;
    std::atomic<int> ended = 0;
    TaskQueue tasks;
    for (int i = 0; i < 50; ++i)
      tasks.add([&] {
        ++begun;
        ++ended;
      });
    tasks.drop();
    const int count = begun;
    CHECK(ended == count);
    tasks.finish();
    CHECK(begun == count);
  }
  TaskQueue().finish();
}

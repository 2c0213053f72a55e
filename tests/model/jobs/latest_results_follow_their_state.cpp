// SPDX-License-Identifier: GPL-3.0-or-later
// Results that are computed aside for the state asked for last, and the count of such work.
#include <catch2/catch.hpp>
#include <new>
#include <optional>
#include <semaphore>
#include <string>

#include "app/system/latest.h"

using namespace mes;

namespace {

/// Computations that end one by one, when they are told to or given up; their result is the state as text.
struct LatestBench {
  explicit LatestBench(Outdated outdated = Outdated::finish) : latest(wake, outdated) {}

  bool follow(int state) {
    return latest.follow(state, [&] {
      ++begun;
      return [this, state](JobControl& job) -> Expected<std::string> {
        while (!may_end.try_acquire()) job.checkpoint();
        if (state < 0) return std::unexpected(Error{ErrorCode::cannot_compute, "below zero"});
        if (state == 0) throw std::bad_alloc();
        return std::to_string(state);
      };
    });
  }
  /// Lets the computation end, and waits until it has.
  void end() {
    may_end.release();
    woken.acquire();
  }
  std::string text() const { return latest.result() ? *latest.result() : std::string(); }

  std::counting_semaphore<> woken{0};
  std::counting_semaphore<> may_end{0};
  int begun = 0;
  Waker wake{[this] { woken.release(); }};
  Latest<int, std::string> latest;  // last: it waits for its computation
};

}  // namespace

TEST_CASE("a result is of the state it was begun for, and that of the present state follows it") {
  LatestBench bench;
  CHECK_FALSE(bench.follow(1));
  CHECK_FALSE(bench.follow(2));
  CHECK(bench.begun == 1);
  CHECK(bench.wake.has_work());
  bench.end();
  CHECK_FALSE(bench.wake.has_work());
  CHECK(bench.follow(2));
  CHECK(bench.text() == "1");
  CHECK(bench.latest.state() == 1);
  CHECK_FALSE(bench.latest.is_current());
  CHECK(bench.begun == 2);
  bench.end();
  CHECK(bench.follow(2));
  CHECK(bench.text() == "2");
  CHECK(bench.latest.is_current());
}

TEST_CASE("a state is computed once, with a result or without") {
  for (const int state : {1, -1, 0}) {
    LatestBench bench;
    bench.follow(state);
    bench.end();
    CHECK(bench.follow(state));
    CHECK_FALSE(bench.follow(state));
    CHECK_FALSE(bench.latest.is_under_way());
    CHECK(bench.begun == 1);
    CHECK(bench.latest.is_current() == (state > 0));
    CHECK(bench.latest.problem() == (state > 0 ? "" : state < 0 ? "below zero" : "there is not enough memory"));
    // The problem is that of its state, and the next result ends it.
    bench.follow(7);
    CHECK(bench.latest.problem().empty());
    bench.end();
    bench.follow(7);
    CHECK(bench.text() == "7");
  }
}

TEST_CASE("a computation that nothing follows is given up") {
  LatestBench bench;
  bench.follow(1);
  CHECK(bench.latest.is_followed());
  bench.latest.end_frame();
  CHECK(bench.latest.is_under_way());
  bench.latest.end_frame();  // nothing has followed it since
  bench.woken.acquire();
  CHECK_FALSE(bench.latest.is_under_way());
  CHECK_FALSE(bench.follow(1));
  CHECK(bench.begun == 2);
  bench.end();
  CHECK(bench.follow(1));
  CHECK(bench.text() == "1");
}

TEST_CASE("a computation of an earlier state is given up where that is wanted") {
  LatestBench bench(Outdated::give_up);
  bench.follow(1);
  bench.follow(1);
  CHECK(bench.begun == 1);
  bench.follow(2);  // it ends by itself now, and no result comes of it
  bench.woken.acquire();
  CHECK_FALSE(bench.follow(2));
  CHECK(bench.begun == 2);
  bench.end();
  CHECK(bench.follow(2));
  CHECK(bench.text() == "2");
  CHECK(bench.latest.is_current());
}

TEST_CASE("work is counted over all copies of a waker, until it ends") {
  int woken = 0;
  const Waker wake([&] { ++woken; });
  const Waker copy = wake;
  CHECK_FALSE(wake.has_work());
  std::optional<Waker::Work> first = copy.begin_work();
  {
    Waker::Work second = wake.begin_work();
    Waker::Work moved = std::move(second);
    first.reset();
    CHECK(wake.has_work());
    moved.end();
    moved.end();
    CHECK_FALSE(wake.has_work());
  }
  CHECK_FALSE(copy.has_work());
  copy();
  CHECK(woken == 1);
  const Waker nothing;
  nothing();
  CHECK_FALSE(nothing.has_work());
}

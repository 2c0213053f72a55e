// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <condition_variable>
#include <latch>
#include <memory>
#include <mutex>
#include <new>
#include <semaphore>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "app/system/background_job.h"

using namespace mes;

namespace {

/// A job, and the way to wait until its call has ended.
template <class Result>
struct JobBench {
  std::counting_semaphore<> woken{0};
  BackgroundJob<Result> job{[this] { woken.release(); }};
};

/// Ends when it is asked to, and not before.
void wait_for(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any asked;
  std::unique_lock lock(mutex);
  asked.wait(lock, stop, [] { return false; });
}

}  // namespace

TEST_CASE("what a call returns is delivered once, when it has ended") {
  std::binary_semaphore may_end{0};
  JobBench<std::string> desk;
  CHECK_FALSE(desk.job.is_under_way());
  CHECK_FALSE(desk.job.poll());
  CHECK_FALSE(desk.job.finish());

  desk.job.begin([&](const std::stop_token&) {
    may_end.acquire();
    return std::string("done");
  });
  CHECK(desk.job.is_under_way());
  CHECK_FALSE(desk.job.poll());
  may_end.release();
  desk.woken.acquire();
  CHECK(desk.job.poll() == "done");
  CHECK_FALSE(desk.job.is_under_way());
  CHECK_FALSE(desk.job.poll());
  CHECK_FALSE(desk.job.finish());
}

TEST_CASE("finish waits for the end of the call") {
  JobBench<std::thread::id> desk;
  desk.job.begin([](const std::stop_token&) { return std::this_thread::get_id(); });
  const auto id = desk.job.finish();
  REQUIRE(id);
  CHECK(*id != std::this_thread::get_id());
  CHECK(desk.woken.try_acquire());
  CHECK_FALSE(desk.job.finish());
}

TEST_CASE("what a call throws is thrown where its result is asked for, and the next call is not touched by it") {
  JobBench<int> desk;
  desk.job.begin([](const std::stop_token&) -> int { throw std::bad_alloc(); });
  desk.woken.acquire();
  CHECK_THROWS_AS(desk.job.poll(), std::bad_alloc);
  CHECK_FALSE(desk.job.is_under_way());
  CHECK_FALSE(desk.job.poll());

  desk.job.begin([](const std::stop_token&) -> int { throw std::runtime_error("why"); });
  CHECK_THROWS_WITH(desk.job.finish(), "why");
  CHECK_FALSE(desk.job.finish());

  desk.job.begin([](const std::stop_token&) { return 7; });
  CHECK(desk.job.finish() == 7);
}

TEST_CASE("of calls begun in a row only the last is delivered, and it waits for none of them") {
  std::binary_semaphore may_end{0};
  JobBench<int> desk;
  desk.job.begin([&](const std::stop_token&) {
    may_end.acquire();
    return 1;
  });
  desk.job.begin([](const std::stop_token&) -> int { throw std::runtime_error("given up"); });
  desk.job.begin([](const std::stop_token&) { return 3; });
  CHECK(desk.job.finish() == 3);
  CHECK_FALSE(desk.job.is_under_way());
  CHECK_FALSE(desk.job.poll());
  may_end.release();
}

TEST_CASE("a call that is given up is asked to stop, and delivers nothing") {
  std::latch has_stopped(1);
  JobBench<int> desk;
  desk.job.give_up();
  desk.job.begin([&](const std::stop_token& stop) {
    wait_for(stop);
    has_stopped.count_down();
    return 1;
  });
  desk.job.give_up();
  CHECK_FALSE(desk.job.is_under_way());
  has_stopped.wait();
  desk.woken.acquire();
  CHECK_FALSE(desk.job.poll());
  CHECK_FALSE(desk.job.finish());
}

TEST_CASE("the destructor asks running calls to stop and waits for their ends") {
  std::vector<std::string> log;
  std::binary_semaphore may_end{0};
  {
    BackgroundJob<int> job({});
    // One that was given up and does not look at its stop token, and one that waits for nothing else.
    job.begin([&](const std::stop_token&) {
      may_end.acquire();
      log.emplace_back("complete");
      return 1;
    });
    job.begin([&](const std::stop_token& stop) {
      wait_for(stop);
      log.emplace_back("asked");
      may_end.release();
      return 2;
    });
  }
  log.emplace_back("destroyed");
  CHECK(log == std::vector<std::string>{"asked", "complete", "destroyed"});
}

TEST_CASE("what a call returned is not destroyed by the thread that gives it up") {
  struct Large {
    std::thread::id* destroyed_by;
    std::binary_semaphore* destroyed;
    ~Large() {
      *destroyed_by = std::this_thread::get_id();
      destroyed->release();
    }
  };
  std::thread::id destroyed_by;
  std::binary_semaphore destroyed{0};
  const auto large = [&](const std::stop_token&) { return std::make_shared<Large>(&destroyed_by, &destroyed); };
  const auto is_destroyed_elsewhere = [&] {
    destroyed.acquire();
    return destroyed_by != std::this_thread::get_id();
  };
  JobBench<std::shared_ptr<Large>> desk;
  // It had ended, and nothing is begun in its place.
  desk.job.begin(large);
  desk.woken.acquire();
  REQUIRE(desk.job.has_ended());
  desk.job.give_up();
  CHECK(is_destroyed_elsewhere());
  CHECK_FALSE(desk.job.is_ending());
  // It has ended, and another one is begun.
  desk.job.begin(large);
  desk.woken.acquire();
  desk.job.begin([](const std::stop_token&) { return nullptr; });
  CHECK(is_destroyed_elsewhere());
  CHECK(desk.job.finish());
  // It ends later.
  desk.job.begin([&](const std::stop_token& stop) {
    wait_for(stop);
    return large(stop);
  });
  desk.job.give_up();
  CHECK(is_destroyed_elsewhere());
}

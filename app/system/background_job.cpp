// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/background_job.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>

namespace mes {

struct BackgroundRuns::Run {
  enum class Delivery : std::uint8_t { awaited, ready, unwanted };
  std::atomic<bool> has_ended = false;
  std::atomic<Delivery> delivery = Delivery::awaited;
  std::atomic<bool> is_empty = false;  // the result has been destroyed
  std::shared_ptr<void> result;
  std::exception_ptr failure;
  void drop() {
    result.reset();
    failure = nullptr;
    is_empty = true;
  }
  std::jthread thread;  // last: joined before the members it writes to are destroyed
};

BackgroundRuns::BackgroundRuns(Waker wake) : wake_(std::move(wake)) {}

BackgroundRuns::~BackgroundRuns() {
  if (run_) run_->thread.request_stop();
}

void BackgroundRuns::begin(Call call) {
  give_up();
  std::erase_if(given_up_, [](const auto& run) { return run->is_empty.load(); });
  auto run = std::make_unique<Run>();
  run->thread = std::jthread([run = run.get(), call = std::move(call), wake = wake_,
                              work = wake_.begin_work()](const std::stop_token& stop) mutable {
    try {
      run->result = call(stop);
    } catch (...) {
      run->failure = std::current_exception();
    }
    auto before = Run::Delivery::awaited;
    if (!run->delivery.compare_exchange_strong(before, Run::Delivery::ready)) run->drop();
    run->has_ended = true;
    work.end();
    wake();
  });
  run_ = std::move(run);
}

void BackgroundRuns::give_up() {
  if (!run_) return;
  run_->thread.request_stop();
  Run& run = *run_;
  given_up_.push_back(std::move(run_));
  auto before = Run::Delivery::awaited;
  if (run.delivery.compare_exchange_strong(before, Run::Delivery::unwanted)) return;
  try {
    // The run's former thread has finished; the assignment joins it.
    run.thread = std::jthread([&run] { run.drop(); });
  } catch (const std::exception&) {
    run.drop();
  }
}

bool BackgroundRuns::is_ending() const {
  return std::ranges::any_of(given_up_, [](const auto& run) { return !run->has_ended; });
}

bool BackgroundRuns::has_ended() const {
  return run_ && run_->has_ended;
}

std::shared_ptr<void> BackgroundRuns::finish() {
  if (!run_) return nullptr;
  const std::unique_ptr<Run> run = std::move(run_);
  run->thread.join();
  if (run->failure) std::rethrow_exception(run->failure);
  return std::move(run->result);
}

}  // namespace mes

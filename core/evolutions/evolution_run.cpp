// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolutions/evolution_run.h"

#include <exception>
#include <new>
#include <utility>

namespace mes {

EvolutionRun::EvolutionRun(Options options)
    : options_(std::move(options)), thread_([this](const std::stop_token& ending) { work(ending); }) {}

EvolutionRun::~EvolutionRun() {
  thread_.request_stop();
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
}

void EvolutionRun::begin(EvolutionState beginning, EvolutionChoice choice) {
  auto states = std::make_shared<EvolutionStates>(std::move(beginning), std::move(choice), options_.budget_bytes);
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  states_ = std::move(states);
  wanted_.reset();
  answer_.reset();
}

void EvolutionRun::want(std::uint64_t k) {
  {
    const std::lock_guard lock(mutex_);
    // States on the way to a later one are kept, so only a request for an earlier state stops the computation.
    if (!wanted_ || k < *wanted_) stop_.request_stop();
    wanted_ = k;
    answer_.reset();
  }
  changed_.notify_one();
}

void EvolutionRun::cancel() {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  wanted_.reset();
  answer_.reset();
}

std::optional<EvolutionRun::Answer> EvolutionRun::poll() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answer_, std::nullopt);
}

bool EvolutionRun::is_busy() const {
  const std::lock_guard lock(mutex_);
  return wanted_.has_value();
}

Expected<EvolutionStates::Shared> EvolutionRun::compute(EvolutionStates& states, std::uint64_t k, JobControl& job) {
  try {
    return states.at(k, job, [this](std::uint64_t reached) { reached_.store(reached, std::memory_order_relaxed); });
  } catch (const std::bad_alloc&) {
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory", {}, 0, 0});
  } catch (const std::exception& error) {
    return std::unexpected(Error{ErrorCode::cannot_compute, error.what(), {}, 0, 0});
  }
}

void EvolutionRun::work(const std::stop_token& ending) {
  for (;;) {
    std::shared_ptr<EvolutionStates> states;
    std::uint64_t k = 0;
    JobControl job;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, ending, [this] { return wanted_.has_value(); })) return;
      states = states_;
      k = *wanted_;
      stop_ = {};
      job.set_token(stop_.get_token());
      if (ending.stop_requested()) return;
    }
    try {
      auto state = compute(*states, k, job);
      {
        const std::lock_guard lock(mutex_);
        // A newer request gets its own answer.
        if (states != states_ || wanted_ != k) continue;
        wanted_.reset();
        answer_ = Answer{k, std::move(state)};
      }
      if (options_.wake) options_.wake();
    } catch (const Cancelled&) {
      continue;
    }
  }
}

}  // namespace mes

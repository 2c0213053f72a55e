// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the states of one evolution on a thread of its own.
//
// Guarantees:
//  1. No call waits for a computation.
//  2. The last request counts; the computation for an earlier one is abandoned unless it lies on the way. Exactly one
//     answer follows the last request, unless `cancel` or `begin` came first.
//
// Smallest use:
//     EvolutionRun run({});
//     run.begin(state_of(document), choice);
//     run.want(12);
//     if (auto answer = run.poll()) show(*answer);  // from time to time
//
// Threads: all methods may be called from one other thread. The thread of the run calls `wake`.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/evolutions/evolution_states.h"

namespace mes {

class EvolutionRun {
 public:
  struct Options {
    std::function<void()> wake;  ///< an answer is ready; must be quick and must not throw
    std::size_t budget_bytes = EvolutionStates::kDefaultBudget;
  };
  struct Answer {
    std::uint64_t k = 0;
    Expected<EvolutionStates::Shared> state;
  };

  explicit EvolutionRun(Options options);
  ~EvolutionRun();
  EvolutionRun(const EvolutionRun&) = delete;
  EvolutionRun& operator=(const EvolutionRun&) = delete;

  /// Forgets all computed states and requests.
  void begin(EvolutionState beginning, EvolutionChoice choice);
  void want(std::uint64_t k);
  void cancel();
  /// The answer to the last request; returned only once.
  std::optional<Answer> poll();
  bool is_busy() const;
  /// Number of the last state computed on the way to the requested one.
  std::uint64_t reached() const { return reached_.load(std::memory_order_relaxed); }

 private:
  void work(const std::stop_token& ending);
  Expected<EvolutionStates::Shared> compute(EvolutionStates& states, std::uint64_t k, JobControl& job);

  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<EvolutionStates> states_;  // used only by the thread, but exchanged under the mutex
  std::optional<std::uint64_t> wanted_;
  std::optional<Answer> answer_;
  std::stop_source stop_;  // stops the running computation
  std::atomic<std::uint64_t> reached_{0};
  std::jthread thread_;
};

}  // namespace mes

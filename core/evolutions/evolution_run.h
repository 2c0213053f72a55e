// SPDX-License-Identifier: GPL-3.0-or-later
// The states of one evolution, computed on a thread of their own.
//
// What it guarantees:
//  1. No call waits for a computation.
//  2. Of several wishes the last counts; what is being computed for an earlier one is given up where it does not lie
//     on the way. Exactly one answer follows the last wish, unless `cancel` or `begin` came first.
//
// Smallest use:
//     EvolutionRun run({});
//     run.begin(state_of(document), choice);
//     run.want(12);
//     if (auto answer = run.poll()) show(*answer);  // from time to time
//
// Threads: all methods may be called from one other thread. `wake` is called from the thread of the run.
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

  /// Forgets everything that was computed and wished for.
  void begin(EvolutionState beginning, EvolutionChoice choice);
  void want(std::uint64_t k);
  void cancel();
  /// The answer to the last wish, once.
  std::optional<Answer> poll();
  bool is_busy() const;
  /// Number of the last state that was reached on the way to the wanted one.
  std::uint64_t reached() const { return reached_.load(std::memory_order_relaxed); }

 private:
  void work(const std::stop_token& ending);
  Expected<EvolutionStates::Shared> compute(EvolutionStates& states, std::uint64_t k, JobControl& job);

  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<EvolutionStates> states_;  // used by the thread only, but exchanged under the mutex
  std::optional<std::uint64_t> wanted_;
  std::optional<Answer> answer_;
  std::stop_source stop_;  // of what is being computed
  std::atomic<std::uint64_t> reached_{0};
  std::jthread thread_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the target in a process that is watched by another, which outlives whatever an input does to it.
//
// Guarantees: an input that ends the process, by a signal, by a sanitizer, or by taking more processor time
// than any input may, is still at hand afterwards. Processor time is limited rather than time, so that a busy machine
// fails nothing; a process that does not get on at all is given up after minutes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace mes::fuzz {

/// Inputs are not longer.
inline constexpr std::size_t kLongestInput = std::size_t{1} << 20U;

/// What the watched process tells the other.
struct Report {
  std::uint64_t runs = 0;
  std::uint64_t inputs = 0;  ///< that reached something new
  std::uint64_t edges = 0;
  double dearest = 0.0;  ///< basic blocks entered for each byte, at most
};

class WatchedRun {
 public:
  explicit WatchedRun(const Target& target);
  ~WatchedRun();
  WatchedRun(const WatchedRun&) = delete;
  WatchedRun& operator=(const WatchedRun&) = delete;

  /// Does the work in a process of its own and waits for its end. Empty when it ended well, otherwise what ended it.
  std::string watch(const std::function<void()>& work, bool is_quiet = false);

  /// In that process: gives the input to the target, with counters of coverage and memory at zero. `name` says where
  /// it comes from.
  void run(std::string_view input, std::string_view name);
  Report& report();

  /// The input that was run last, also by a process that is gone.
  std::string input() const;
  std::string name() const;

 private:
  struct Shared;
  const Target& target_;
  Shared* shared_;
};

}  // namespace mes::fuzz

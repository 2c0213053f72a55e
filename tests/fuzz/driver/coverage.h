// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the edges of the program that a run takes and the blocks it enters (`-fsanitize-coverage=trace-pc`).
//
// The compiler calls a function at the beginning of each basic block. A block and the one before it are hashed to
// the place of a counter; two edges may share one, which costs the fuzzer a little and is never wrong. Without that
// option no counter ever moves, and everything else works as it does with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mes::fuzz {

/// Counters of one run. Other threads count too, so runs that use several may differ a little.
void begin_counting();
/// Basic blocks entered since: the work of a run, which is the same on every machine but for what other threads and
/// libraries do. 0 in builds that do not count.
std::uint64_t blocks_entered();

/// Everything that runs have reached, by edge and by the order of magnitude of how often.
class Reached {
 public:
  Reached();
  /// Adds the run since `begin_counting`. Returns the number of things that no run before had reached.
  std::size_t add_run();
  std::size_t edges() const;

 private:
  std::vector<std::uint8_t> seen_;  // a bit for each order of magnitude
};

}  // namespace mes::fuzz

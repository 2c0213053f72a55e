// SPDX-License-Identifier: GPL-3.0-or-later
// The program's table behind a public one.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <mesecina/table.h>

#include "core/graph/table_columns.h"

namespace mesecina {
inline namespace v1 {

/// Shared by a workbench and its tables: counts runs, and records the structures that each run computed.
class RunClock {
 public:
  explicit RunClock(std::size_t structures) : computed_(structures) {}

  /// Closes all tables to readers until `open`.
  void begin_run() noexcept {
    close();
    run_.fetch_add(1, std::memory_order_acq_rel);
  }
  /// Records that the tables of the structure may have moved in that run, but not since.
  void set_computed(std::size_t structure, std::uint64_t run) noexcept {
    computed_[structure].store(run, std::memory_order_relaxed);
  }
  void open() noexcept { is_open_.store(true, std::memory_order_release); }
  void close() noexcept { is_open_.store(false, std::memory_order_release); }

  std::uint64_t run() const noexcept { return run_.load(std::memory_order_acquire); }
  std::uint64_t computed(std::size_t structure) const noexcept {
    return computed_[structure].load(std::memory_order_relaxed);
  }
  bool is_open() const noexcept { return is_open_.load(std::memory_order_acquire); }

 private:
  std::atomic<std::uint64_t> run_ = 0;
  std::atomic<bool> is_open_ = true;
  std::vector<std::atomic<std::uint64_t>> computed_;
};

TableInfo info_of(std::string_view structure, const mes::TableColumns& table);

struct TableAccess {
  TableInfo info;
  mes::TableColumns table;
  std::shared_ptr<const RunClock> clock;
  std::size_t structure = 0;   ///< its index in the clock
  std::uint64_t computed = 0;  ///< the run that computed its structure
  std::uint64_t run = 0;       ///< the run after which the table was made
  bool is_rebuilt = false;     ///< every row may be new

  bool is_current() const noexcept { return clock->is_open() && clock->computed(structure) == computed; }
  /// Error: `usage`.
  const mes::TableColumns& current() const;
};

}  // namespace v1
}  // namespace mesecina

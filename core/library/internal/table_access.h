// SPDX-License-Identifier: GPL-3.0-or-later
// A table of a structure behind a public one.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>

#include <mesecina/table.h>

#include "core/graph/table_columns.h"

namespace mesecina {
inline namespace v1 {

/// Number of the last run that a workbench has begun. Tables and workbench share it.
using RunNumber = std::atomic<std::uint64_t>;
inline constexpr std::uint64_t kNoMoreRuns = 0xffffffffffffffffULL;

TableInfo info_of(std::string_view structure, const mes::TableColumns& table);

struct TableAccess {
  TableInfo info;
  mes::TableColumns table;
  std::shared_ptr<const RunNumber> last_run;
  std::uint64_t run = 0;    ///< that the table was made after
  bool is_rebuilt = false;  ///< every row may be new

  bool is_current() const noexcept { return last_run->load(std::memory_order_acquire) == run; }
  /// Error: `usage`.
  const mes::TableColumns& current() const;
};

}  // namespace v1
}  // namespace mesecina

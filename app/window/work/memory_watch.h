// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that memory ran out.
#pragma once

#include <cstdint>
#include <optional>

#include "app/actions/messages.h"
#include "app/window/work/memory_problem.h"
#include "core/document/document.h"

namespace mes {

/// Guarantees: one problem is reported for each state of the document that lacks memory, and removed when there is
/// room again. Grey layers then need no message of their own. Threads: none.
class MemoryWatch {
 public:
  /// Returns true if there is a new problem to show.
  bool follow(bool lacks_memory, const Document& document, Messages& messages) {
    if (!lacks_memory) {
      if (std::exchange(told_at_, std::nullopt) && is_memory_problem(messages.problem())) messages.clear_problem();
      return false;
    }
    if (std::exchange(told_at_, document.revision()) == document.revision()) return false;
    messages.problem(memory_problem(document.sample_count(), document.ball_count()));
    return true;
  }
  /// Another document has replaced this one.
  void forget() { told_at_.reset(); }

 private:
  std::optional<std::uint64_t> told_at_;  // revision of the document
};

}  // namespace mes

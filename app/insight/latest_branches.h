// SPDX-License-Identifier: GPL-3.0-or-later
// The branch table of the displayed document, and the chosen branch.
//
// Guarantees:
//  1. No call waits: the table is computed from scratch on a thread of its own. It belongs to one state of document
//     and settings; `is_current` says whether that is the state requested last.
//  2. Nothing is computed in frames without a call of `follow`.
//  3. A branch stays chosen if the next table has a branch with the same two ends.
//
// Smallest use, once a frame:
//     const LatestBranches::State state{document.revision(), settings, BranchAxis::lambda};
//     if (latest.follow(state, data)) draw(*latest.table());
//
// Cost: the axis from scratch, beside the window. Threads: the window's; `wake` is called from the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/insight/branch_table.h"
#include "app/system/latest.h"
#include "core/graph/live_registry.h"

namespace mes {

class LatestBranches {
 public:
  LatestBranches(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  struct State {
    std::uint64_t document = 0;  ///< revision of the document
    ComputationSettings settings{};
    BranchAxis axis = BranchAxis::whole;
    bool measures_area = false;  ///< takes many times longer
    friend bool operator==(const State&, const State&) = default;
  };
  /// Takes a finished table, and begins a missing one. Calls `data` when a computation begins. Returns true if the
  /// table has changed.
  bool follow(const State& wanted, const std::function<SampleData()>& data);
  /// Call it once per frame after all possible calls of `follow`: if there was none, the computation is given up.
  void end_frame() { latest_.end_frame(); }

  /// The last table; null before the first.
  const BranchTable* table() const { return latest_.result().get(); }
  /// The state of the table.
  const State& state() const { return latest_.state(); }
  bool is_current() const { return latest_.is_current(); }
  /// The reason why the state followed last has no table; empty if it has one or is being computed.
  std::string problem() const { return latest_.problem(); }

  /// Chosen row of the table.
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> row) { chosen_ = row; }
  /// Chooses the branch within `reach` of a point, or none if there is none. Returns false if the table does not
  /// match the displayed document.
  bool pick(Vec2 place, double reach);

 private:
  LiveRegistry registry_;
  Latest<State, BranchTable> latest_;
  std::optional<std::size_t> chosen_;
};

}  // namespace mes

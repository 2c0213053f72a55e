// SPDX-License-Identifier: GPL-3.0-or-later
// The table of branches of what is shown, and the one that is chosen.
//
// What it guarantees:
//  1. Nothing waits: the table is computed afresh on a thread of its own. It is of one state of the document and of the
//     settings; `is_current` says whether that is the state asked for last.
//  2. In frames in which nothing follows it, nothing is computed.
//  3. A branch stays chosen in the next table if one there has the same two ends.
//
// Smallest use, once a frame:
//     if (desk.follow(BranchDesk::State{document.revision(), settings, BranchAxis::lambda}, data)) draw(*desk.table());
//
// Cost: of the axis from scratch, beside the window. Threads: the window's; `wake` is called from the other.
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

class BranchDesk {
 public:
  BranchDesk(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  struct State {
    std::uint64_t document = 0;  ///< revision
    ComputationSettings settings{};
    BranchAxis axis = BranchAxis::whole;
    bool measures_area = false;  ///< takes many times longer
    friend bool operator==(const State&, const State&) = default;
  };
  /// Takes what is ready, and begins what is missing. `data` is called when a computation begins. True when there is
  /// another table now.
  bool follow(const State& wanted, const std::function<SampleData()>& data);
  /// Once a frame, after those who may follow: what nothing followed is given up.
  void end_frame() { latest_.end_frame(); }

  /// The last one; null before the first.
  const BranchTable* table() const { return latest_.result().get(); }
  /// The state of the table.
  const State& state() const { return latest_.state(); }
  bool is_current() const { return latest_.is_current(); }
  /// Why there is no table of the state followed last; empty: there is one, or it is being computed.
  std::string problem() const { return latest_.problem(); }

  /// Row of the table.
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> row) { chosen_ = row; }
  /// Chooses the branch within `reach` of a place, or no branch if there is none. False while the table is not that of
  /// what is shown.
  bool pick(Vec2 place, double reach);

 private:
  LiveRegistry registry_;
  Latest<State, BranchTable> latest_;
  std::optional<std::size_t> chosen_;
};

}  // namespace mes

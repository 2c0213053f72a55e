// SPDX-License-Identifier: GPL-3.0-or-later
// Selecting along the curve: all of it, or a sample farther at each end.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/crust_chains.h"
#include "app/system/waker.h"

namespace mes {

/// What it guarantees: the curve is the one-step crust of the samples, whatever is shown (app/editing/crust_chains.h). Until
/// it is found nothing is selected, and a document that changes meanwhile drops the wish. Balls stay selected or not.
///
/// Smallest use:
///     selector.begin(CurveSelector::Wish::whole);
///     ... once a turn: selector.follow();
///
/// Cost: O(rows) on the window's thread. Threads: the window's; `wake` is called from another.
class CurveSelector {
 public:
  CurveSelector(Editor& editor, Waker wake) : editor_(editor), crust_(editor, std::move(wake)) {}

  enum class Wish : std::uint8_t {
    whole,   ///< every curve with a selected sample on it
    grow,    ///< what is next to something selected, too
    shrink,  ///< not what is next to something that is not selected
  };
  void begin(Wish wish);
  bool is_under_way() const { return crust_.is_under_way(); }
  /// Takes the curve when it was found, and selects. Error: the crust could not be computed.
  Expected<void> follow();
  /// What was selected last, or why nothing changed; once, and empty where there is nothing to say.
  std::string take_remark() { return std::exchange(remark_, {}); }

 private:
  void select(const CrustChains::Curve& curve, Wish wish);

  Editor& editor_;
  CrustChains crust_;
  std::vector<Wish> wishes_;
  std::string remark_;
};

}  // namespace mes

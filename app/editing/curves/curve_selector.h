// SPDX-License-Identifier: GPL-3.0-or-later
// Selects along the curve: all of it, or one sample more or less at each end.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/curves/crust_chains.h"
#include "app/system/waker.h"

namespace mes {

/// Guarantees: the curve is the one-step crust of the samples, whatever is shown (app/editing/curves/crust_chains.h).
/// Nothing is selected before it is found, and a change of the document meanwhile drops the request. The selection of
/// balls stays.
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
    grow,    ///< adds the neighbours of selected samples
    shrink,  ///< removes the neighbours of samples that are not selected
  };
  void begin(Wish wish);
  bool is_under_way() const { return crust_.is_under_way(); }
  /// Takes the curve once it is found, and selects along it. Error: the crust could not be computed.
  Expected<void> follow();
  /// The last effect on the selection, or the reason why there was none; given once, and empty if there is no
  /// message.
  std::string take_remark() { return std::exchange(remark_, {}); }

 private:
  void select(const CrustChains::Curve& curve, Wish wish);

  Editor& editor_;
  CrustChains crust_;
  std::vector<Wish> wishes_;
  std::string remark_;
};

}  // namespace mes

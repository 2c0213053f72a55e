// SPDX-License-Identifier: GPL-3.0-or-later
// Selecting along the curve: all of it, or a sample farther at each end.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/model/editor.h"
#include "app/system/background_job.h"

namespace mes {

/// What it guarantees: the curve is the one-step crust of the samples, whatever is shown. It is found on a thread of its
/// own, once for each state of the document; until then nothing is selected, and a document that changes meanwhile drops
/// the wish. Balls stay selected or not.
///
/// Smallest use:
///     selector.begin(CurveSelector::Wish::whole);
///     ... once a turn: selector.follow();
///
/// Cost: O(n log n) on the thread, O(rows) on that of the window. Threads: the window's; `wake` is called from the other.
class CurveSelector {
 public:
  CurveSelector(Editor& editor, std::function<void()> wake) : editor_(editor), job_(std::move(wake)) {}

  enum class Wish : std::uint8_t {
    whole,   ///< every curve with a selected sample on it
    grow,    ///< what is next to something selected, too
    shrink,  ///< not what is next to something that is not selected
  };
  void begin(Wish wish);
  bool is_under_way() const { return job_.is_under_way(); }
  /// Takes the curve when it was found, and selects. Error: the crust could not be computed.
  Expected<void> follow();

 private:
  /// Chains of rows: neighbours are neighbours on the curve.
  struct Curve {
    struct Chain {
      bool closed = true;
      std::vector<SampleSlot> samples;
    };
    std::vector<Chain> chains;
    /// A sample and the one at the same place that stands for it in the chains.
    std::vector<std::pair<SampleSlot, SampleSlot>> followers;
  };
  void select(Wish wish);

  Editor& editor_;
  BackgroundJob<std::shared_ptr<const Curve>> job_;
  std::vector<Wish> wishes_;
  std::uint64_t wished_at_ = 0;  // revision of the document
  std::shared_ptr<const Curve> curve_;
  std::uint64_t curve_of_ = ~std::uint64_t{0};
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The chains of the one-step crust of the document, whatever is shown.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/system/background_job.h"

namespace mes {

/// What it guarantees: the chains are found on a thread of its own, once for each state of the document that they are
/// asked for; those of a document that has changed meanwhile are dropped.
///
/// Cost: O(n log n) on the thread. Threads: the window's; `wake` is called from the other.
class CrustChains {
 public:
  CrustChains(const Editor& editor, Waker wake) : editor_(editor), job_(std::move(wake)) {}

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

  /// Those of the document as it is; null where they are not known. `find` has them found.
  const Curve* now() const;
  /// False: they are being found already.
  bool find();
  bool is_under_way() const { return job_.is_under_way(); }
  /// Whether chains were found, of the document as it is now or as it was. Error: the crust could not be computed.
  Expected<bool> follow();

 private:
  const Editor& editor_;
  BackgroundJob<std::shared_ptr<const Curve>> job_;
  std::uint64_t wanted_of_ = 0;  // revision of the document
  std::shared_ptr<const Curve> curve_;
  std::uint64_t curve_of_ = ~std::uint64_t{0};
};

}  // namespace mes

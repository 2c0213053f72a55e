// SPDX-License-Identifier: GPL-3.0-or-later
// The chains of the one-step crust of the document, whatever layers are shown.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/system/background_job.h"

namespace mes {

/// Guarantees: a separate thread finds the chains, once for each state of the document for which they are requested;
/// if the document has changed meanwhile, they are dropped.
///
/// Cost: O(n log n) on the thread. Threads: the window's; `wake` is called from the other.
class CrustChains {
 public:
  CrustChains(const Editor& editor, Waker wake) : editor_(editor), job_(std::move(wake)) {}

  /// Chains of rows: neighbours in a chain are neighbours on the curve.
  struct Curve {
    struct Chain {
      bool closed = true;
      std::vector<SampleSlot> samples;
    };
    std::vector<Chain> chains;
    /// A duplicate, and the sample at the same position that represents it in the chains.
    std::vector<std::pair<SampleSlot, SampleSlot>> followers;
  };

  /// The chains of the present document; null if they are unknown. Call `find` to compute them.
  const Curve* now() const;
  /// Begins to find the chains; returns false if that is under way already.
  bool find();
  bool is_under_way() const { return job_.is_under_way(); }
  /// True if chains were found, for the present document or an earlier state. Error: the crust could not be computed.
  Expected<bool> follow();

 private:
  const Editor& editor_;
  BackgroundJob<std::shared_ptr<const Curve>> job_;
  std::uint64_t wanted_of_ = 0;  // revision of the document
  std::shared_ptr<const Curve> curve_;
  std::uint64_t curve_of_ = ~std::uint64_t{0};
};

}  // namespace mes

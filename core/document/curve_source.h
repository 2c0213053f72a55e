// SPDX-License-Identifier: GPL-3.0-or-later
// The curves that samples were taken from. Plain data.
#pragma once

#include <cstdint>
#include <memory>

#include "core/curves/curve.h"
#include "core/curves/sampling.h"

namespace mes {

/// Curves as a file, a picture or a shape had them, and how samples were taken, so that others can be taken.
struct CurveSource {
  std::shared_ptr<const CurveSet> curves{};  ///< never null; shared by all samplings of them
  SamplingRequest sampling{};
  /// The samples: `count` of them from the number `first` on, of those that there were since the data were opened
  /// (in `SampleData`, by their place in `positions`). Some may be moved or gone.
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const CurveSource& a, const CurveSource& b) {
    return (a.curves == b.curves || *a.curves == *b.curves) && a.sampling == b.sampling && a.first == b.first &&
           a.count == b.count;
  }
};

}  // namespace mes

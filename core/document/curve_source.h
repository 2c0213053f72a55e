// SPDX-License-Identifier: GPL-3.0-or-later
// The source curves of samples. Plain data.
#pragma once

#include <cstdint>
#include <memory>

#include "core/curves/curve.h"
#include "core/curves/sampling.h"

namespace mes {

/// Curves from a file, a picture or a shape, with the request that sampled them, so that they can be sampled again.
struct CurveSource {
  std::shared_ptr<const CurveSet> curves{};  ///< never null; shared by all samplings of them
  SamplingRequest sampling{};
  /// The samples: `count` indices from `first` on, counted since the data were opened (in `SampleData`, indices into
  /// `positions`). Some may have been moved or removed.
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const CurveSource& a, const CurveSource& b) {
    return (a.curves == b.curves || *a.curves == *b.curves) && a.sampling == b.sampling && a.first == b.first &&
           a.count == b.count;
  }
};

}  // namespace mes

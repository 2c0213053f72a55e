// SPDX-License-Identifier: GPL-3.0-or-later
// Finds samples at which a contour of a file crosses or touches itself. Private to core/io.
#pragma once

#include <fmt/core.h>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"

namespace mes {

/// One remark reports all, with the line of the first such contour. Readers have already merged repeated corners.
///
/// Smallest use:
///     RepeatedCorners repeated;
///     for (const SampleData::Contour& contour : data.contours) repeated.add(contour);
///     if (auto remark = repeated.remark(name)) warnings.push_back(*std::move(remark));
///
/// Cost: O(n log n).
class RepeatedCorners {
 public:
  /// `line`: 0 if unknown.
  void add(const SampleData::Contour& contour, std::uint64_t line = 0) {
    std::vector<std::uint32_t> sorted = contour.points;
    std::ranges::sort(sorted);
    const std::size_t before = repeated_.size();
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i] == sorted[i - 1]) repeated_.push_back(sorted[i]);
    if (before == 0 && !repeated_.empty()) line_ = line;
  }
  std::optional<std::string> remark(const std::string& name) {
    if (repeated_.empty()) return std::nullopt;
    std::ranges::sort(repeated_);
    const auto count = std::ranges::unique(repeated_).begin() - repeated_.begin();
    std::string text =
        count == 1
            ? "1 sample is on its contour more than once; evolutions do not move it"
            : fmt::format("{} samples are on their contour more than once; evolutions do not move them", count);
    return Error{ErrorCode::bad_input, std::move(text), name, line_, line_ == 0 ? 0U : 1U}.message();
  }

 private:
  std::vector<std::uint32_t> repeated_;
  std::uint64_t line_ = 0;
};

}  // namespace mes

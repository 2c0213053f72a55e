// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks about a file, one for all things of a kind. Private to core/io.
#pragma once

#include <fmt/core.h>
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/io/text/text_numbers.h"

namespace mes {

/// Smallest use:
///     CountedRemarks remarks;
///     remarks.add("text element is left out", "text elements are left out", place);
///     remarks.for_each([&](const std::string& text, std::size_t at) { warn(text, at); });
class CountedRemarks {
 public:
  /// `one` follows "1", `many` any other number. The remark gives the first position. A file can invent kinds, so all
  /// kinds after the first two dozen are merged into one.
  void add(std::string one, std::string many, std::size_t place) {
    constexpr std::size_t kMostKinds = 24;
    auto known = std::ranges::find(kinds_, one, &Kind::one);
    if (known == kinds_.end() && kinds_.size() >= kMostKinds) {
      one = "thing of another kind is left out";
      many = "things of other kinds are left out";
      known = std::ranges::find(kinds_, one, &Kind::one);
    }
    if (known != kinds_.end()) {
      ++known->count;
      known->place = std::min(known->place, place);
    } else {
      kinds_.push_back({std::move(one), std::move(many), place, 1});
    }
  }

  /// Calls `use(text, place)` for each kind, in the order of addition. The text is printable even if it quotes the
  /// file.
  template <class Use>
  void for_each(Use use) const {
    for (const Kind& kind : kinds_) use(printable(counted(kind.count, kind.one, kind.many)), kind.place);
  }

 private:
  struct Kind {
    std::string one;
    std::string many;
    std::size_t place;
    std::size_t count;
  };
  std::vector<Kind> kinds_;
};

}  // namespace mes

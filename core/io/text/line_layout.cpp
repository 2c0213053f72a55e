// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/line_layout.h"

namespace mes {

void LineLayout::begin_line(std::uint64_t line) {
  end_line();
  line_ = line;
  columns_ = 0;
  if (line == header_line_) is_free_ = true;
}

void LineLayout::end_line() {
  if (columns_ == 0) return;
  const OddLine seen{columns_ > each_ ? extra_ : end_of_line_, columns_};
  columns_ = 0;
  if (last_is_shorter_) is_steady_ = false;
  if (++lines_ == 1) {
    first_ = seen;
    is_free_ = is_free_ || seen.columns == 1 || seen.columns % each_ == 0;
  } else if (seen.columns != first_.columns) {
    if (seen.columns > first_.columns) is_steady_ = false;
    last_is_shorter_ = true;
  }
  if (!odd_ && seen.columns != each_) {
    odd_ = seen;
    odd_index_ = lines_;
  }
}

std::optional<LineLayout::OddLine> LineLayout::contradiction(std::uint64_t announced_things) const {
  const bool are_as_announced = numbers_ == announced_things * each_;
  const std::uint64_t alike = lines_ - (last_is_shorter_ ? 1 : 0);
  if (!is_free() && alike >= 2 && !(last_is_shorter_ && are_as_announced)) {
    OddLine out = first_;
    out.are_all_alike = true;
    return out;
  }
  if (!are_as_announced && lines_ == announced_things && odd_ && odd_index_ < lines_) return odd_;
  return std::nullopt;
}

}  // namespace mes

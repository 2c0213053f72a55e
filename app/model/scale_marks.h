// SPDX-License-Identifier: GPL-3.0-or-later
// What says on a picture how large things are, and where. Plain data.
#pragma once

#include <optional>

#include "app/model/paper_place.h"

namespace mes {

struct ScaleMarks {
  bool bar = false;                    ///< a line of a round length, with that length
  bool axes = false;                   ///< numbers along the lower and the left edge
  bool grid = false;                   ///< faint lines where the axes have their numbers
  std::optional<PaperPlace> bar_at{};  ///< none: the lower left corner
  bool is_empty() const { return !bar && !axes && !grid; }
  friend bool operator==(const ScaleMarks&, const ScaleMarks&) = default;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The marks on a picture that show size and coordinates. Plain data.
#pragma once

#include <optional>

#include "app/settings/paper_place.h"

namespace mes {

struct ScaleMarks {
  bool bar = false;                    ///< a line of a round length, labelled with it
  bool axes = false;                   ///< numbers along the lower and the left edge
  bool grid = false;                   ///< faint lines at the numbers of the axes
  std::optional<PaperPlace> bar_at{};  ///< nothing: the lower left corner
  bool is_empty() const { return !bar && !axes && !grid; }
  friend bool operator==(const ScaleMarks&, const ScaleMarks&) = default;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The positions of panes in the window, and the pane under the pointer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// A rectangle in framebuffer pixels from the upper left corner of the window.
struct PanePlace {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  bool holds(Vec2 px) const { return left <= px.x && px.x < left + width && top <= px.y && px.y < top + height; }
  friend bool operator==(const PanePlace&, const PanePlace&) = default;
};

/// Panes of equal size, the main one first; empty if it is the only one. A position in a pane corresponds to the
/// position in the main pane that shows the same point of the plane.
class PanePlaces {
 public:
  /// Divides a part of the window into columns, into rows if it is high, or two by two. Leaves it whole if panes
  /// would be narrower than `least`.
  static PanePlaces divide(const PanePlace& whole, std::size_t panes, int gap, int least) {
    PanePlaces out;
    if (panes < 2) return out;
    const bool is_wide = whole.width >= whole.height;
    const std::size_t columns = panes == 4 ? 2 : is_wide ? panes : 1;
    const std::size_t rows = (panes + columns - 1) / columns;
    const auto part = [gap](int side, std::size_t parts) {
      return (side - gap * static_cast<int>(parts - 1)) / static_cast<int>(parts);
    };
    const int width = part(whole.width, columns);
    const int height = part(whole.height, rows);
    if (width < least || height < least) return out;
    for (std::size_t i = 0; i < panes; ++i)
      out.places_.push_back({whole.left + static_cast<int>(i % columns) * (width + gap),
                             whole.top + static_cast<int>(i / columns) * (height + gap), width, height});
    return out;
  }

  bool is_empty() const { return places_.empty(); }
  const std::vector<PanePlace>& places() const { return places_; }
  /// The rectangle around all panes; there must be some.
  PanePlace all() const {
    const PanePlace& first = places_.front();
    const PanePlace& last = places_.back();
    const auto right = std::ranges::max(places_, {}, &PanePlace::left);
    return {first.left, first.top, right.left + right.width - first.left, last.top + last.height - first.top};
  }
  /// The pane at a position; the main one outside all panes.
  std::size_t at(Vec2 px) const {
    const auto found = std::ranges::find_if(places_, [px](const PanePlace& place) { return place.holds(px); });
    return found == places_.end() ? 0 : static_cast<std::size_t>(found - places_.begin());
  }
  /// The shift from the main pane to another one.
  Vec2 shift(std::size_t pane) const {
    if (pane >= places_.size()) return {};
    return {static_cast<double>(places_[pane].left - places_.front().left),
            static_cast<double>(places_[pane].top - places_.front().top)};
  }
  friend bool operator==(const PanePlaces&, const PanePlaces&) = default;

 private:
  std::vector<PanePlace> places_;
};

}  // namespace mes

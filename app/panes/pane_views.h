// SPDX-License-Identifier: GPL-3.0-or-later
// The cameras of panes: one for all, or one for each.
//
// A camera is always that of a window in which the pane has the position of the main pane. So positions in a pane and
// in the main pane are the same pixels, and panes of one size need no cameras of other sizes.
//
// Guarantees: while cameras are locked, all panes have the view of the main one. When its camera becomes free, a pane
// begins with that view; the view stays with its pane when others are added or removed.
//
// Smallest use:
//     PaneViews views;
//     views.follow(list.keys(), list.has_free_cameras());
//     views.of(2).zoom_at(px, 1.2);
//
// Cost: O(panes). Threads: none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "app/panes/view_motion.h"

namespace mes {

class PaneViews {
 public:
  ViewMotion& main() { return main_; }
  const ViewMotion& main() const { return main_; }
  /// The view of a pane; the main one is 0.
  ViewMotion& of(std::size_t pane) { return is_own(pane) ? beside_[pane - 1].second : main_; }
  const ViewMotion& of(std::size_t pane) const { return is_own(pane) ? beside_[pane - 1].second : main_; }
  /// True if the view is not that of the main pane.
  bool is_own(std::size_t pane) const { return pane != 0 && pane <= beside_.size(); }

  /// `panes`: those beside the main one, by their permanent numbers (`PaneList::keys`).
  void follow(std::span<const std::uint64_t> panes, bool are_free) {
    if (!are_free) return beside_.clear();
    if (std::ranges::equal(panes, beside_, {}, {}, &Beside::first)) return;
    std::vector<Beside> now;
    for (const std::uint64_t key : panes) {
      const auto known = std::ranges::find(beside_, key, &Beside::first);
      now.emplace_back(key, known == beside_.end() ? main_ : std::move(known->second));
    }
    beside_ = std::move(now);
  }

  void set_viewport(int width, int height) {
    each([&](ViewMotion& view) { view.set_viewport(width, height); });
  }
  void set_insets(const Insets& insets) {
    each([&](ViewMotion& view) { view.set_insets(insets); });
  }
  bool is_moving() const {
    return main_.is_moving() ||
           std::ranges::any_of(beside_, [](const Beside& pane) { return pane.second.is_moving(); });
  }
  void advance(double seconds) {
    each([&](ViewMotion& view) { view.advance(seconds); });
  }

 private:
  using Beside = std::pair<std::uint64_t, ViewMotion>;
  template <class Change>
  void each(Change change) {
    change(main_);
    for (Beside& pane : beside_) change(pane.second);
  }

  ViewMotion main_;
  std::vector<Beside> beside_;  // empty while cameras are locked
};

}  // namespace mes

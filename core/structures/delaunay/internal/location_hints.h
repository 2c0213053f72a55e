// SPDX-License-Identifier: GPL-3.0-or-later
// A site near a given point, from which a walk through the triangulation starts.
#pragma once

#include <algorithm>
#include <vector>

#include "core/structures/delaunay/delaunay.h"
#include "core/structures/triangulation/hilbert.h"

namespace mes {

/// Keeps a random eighth of the sites sorted along a Hilbert curve. A lookup is a binary search in a small array; it
/// skips sites that have died since, and the walk finds those born since. Built at the first use, O(n).
class LocationHints {
 public:
  void clear() {
    sites_.clear();
    built_for_ = 0;
  }
  bool is_stale(std::size_t site_rows) const { return built_for_ == 0 || site_rows > 2 * built_for_; }

  /// `position_of(site)` and `is_alive(site)` describe the sites 0 .. rows-1.
  template <class PositionOf, class IsAlive>
  void build(std::size_t rows, PositionOf position_of, IsAlive is_alive) {
    Box2 box;
    std::vector<SiteSlot> chosen;
    for (const SiteSlot site : slots_below<SiteSlot>(rows)) {
      // A multiplicative hash picks the eighth; its order is random in the plane.
      if (rows > 64 && (site.index() * 2654435761U) >> 29U != 0) continue;
      if (!is_alive(site)) continue;
      chosen.push_back(site);
      box.add(position_of(site));
    }
    grid_ = HilbertGrid(box);
    sites_.clear();
    for (const SiteSlot site : chosen) sites_.push_back({grid_.key(position_of(site)), site});
    std::vector<Keyed<SiteSlot>> scratch;
    radix_sort(sites_, scratch, 32);
    built_for_ = rows;
  }

  /// A live site close to `p`, or kNoSlot.
  template <class PositionOf, class IsAlive>
  SiteSlot near(Vec2 p, PositionOf position_of, IsAlive is_alive) const {
    const std::uint64_t key = grid_.key(p);
    const auto at = std::ranges::lower_bound(sites_, key, {}, &Keyed<SiteSlot>::key) - sites_.begin();
    SiteSlot best;
    double best_distance = 0.0;
    const auto consider = [&](SiteSlot site) {
      const Vec2 d = position_of(site) - p;
      const double squared = dot(d, d);
      if (best == kNoSlot || squared < best_distance) {
        best = site;
        best_distance = squared;
      }
    };
    constexpr std::ptrdiff_t kReach = 4;
    const auto size = static_cast<std::ptrdiff_t>(sites_.size());
    for (auto i = std::max<std::ptrdiff_t>(at - kReach, 0); i < std::min(at + kReach, size); ++i) {
      const SiteSlot site = sites_[static_cast<std::size_t>(i)].slot;
      if (is_alive(site)) consider(site);
    }
    return best;
  }

 private:
  HilbertGrid grid_;
  std::vector<Keyed<SiteSlot>> sites_;
  std::size_t built_for_ = 0;
};

}  // namespace mes

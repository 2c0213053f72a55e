// SPDX-License-Identifier: GPL-3.0-or-later
// The peer we measure against: CGAL's Delaunay triangulation with nothing around it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/base/geometry/vec2.h"

namespace mes::bench {

/// `Delaunay_triangulation_2` over the kernel with exact predicates, as its manual would have it used.
class RawDelaunay {
 public:
  RawDelaunay();
  ~RawDelaunay();
  /// `insert(begin, end)` of all points at once; remembers no vertices.
  void insert_range(std::span<const Vec2> points);
  /// The same, then finds each point's vertex so that it can be edited by its index.
  void insert_range_and_index(std::span<const Vec2> points);

  // Single edits, each one call of CGAL.
  void move(std::size_t index, Vec2 to);                           ///< `move_if_no_collision`
  void remove(std::size_t index);                                  ///< `remove`
  void insert_near(std::size_t index, Vec2 at, std::size_t hint);  ///< `insert` with a face at another vertex as hint

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mes::bench

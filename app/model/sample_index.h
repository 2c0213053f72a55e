// SPDX-License-Identifier: GPL-3.0-or-later
// Where are the samples near the cursor? A hash grid over the live samples of a document.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/base/box2.h"
#include "core/document/document.h"

namespace mes {

/// What it guarantees:
///  1. After `follow` the answers are those of looking at every sample; ties go to the higher row.
///  2. One far outlier does not spoil the grid: the cell size comes from the middle nine tenths of the samples.
///
/// Smallest use:
///     SampleIndex index(document);
///     document.apply(delta); index.follow(delta);
///     SampleSlot slot = index.nearest(cursor_world, 8 * units_per_px);
///
/// Cost: `follow` O(edits) with a rebuild whenever the number of samples has changed fourfold; `nearest` looks at the
/// cells of a few rings (some microseconds at 10^6 samples); `in_box` O(cells of the box + answer).
/// Threads: none; it follows the document of the window's thread.
///
/// How it works inside: cells of level 0 hold the samples as a linked list through the rows; a cell of level k + 1
/// counts the occupied ones of its 4 x 4 children, so a search in a radius of a million empty cells descends only
/// where something is.
class SampleIndex {
 public:
  explicit SampleIndex(const Document& document);

  /// To be called after `document.apply(delta)`, with every delta, in order. Lack of memory makes searches slow, not
  /// wrong.
  void follow(const DocumentDelta& delta);
  /// Row of the sample nearest to `p` at a distance of at most `radius`, or kNoSlot.
  SampleSlot nearest(Vec2 p, double radius) const;
  /// Rows of the samples in the closed box, increasing.
  std::vector<SampleSlot> in_box(const Box2& box) const;
  std::size_t size() const { return is_lost_ ? document_.sample_count() : size_; }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept;
  };
  struct Best {
    SampleSlot slot;
    double distance = 0.0;
  };
  static constexpr std::int64_t kFanout = 4;
  static constexpr std::size_t kLevels = 24;  // 4^24 cells across: more than a double tells apart

  void rebuild();
  void follow_closely(const DocumentDelta& delta);
  double chosen_cell_size() const;
  Cell cell_of(Vec2 p, double size) const;
  void add(SampleSlot slot, Vec2 p);
  void remove(SampleSlot slot, Vec2 p);
  static Cell parent_of(Cell cell);
  Box2 box_of(Cell cell, std::size_t level) const;
  template <class Visit>
  void descend(Cell cell, std::size_t level, const Box2& box, const Visit& visit) const;
  template <class Visit>
  void visit_cells(const Box2& box, const Visit& visit) const;

  const Document& document_;
  double cell_size_ = 1.0;
  Vec2 origin_{};
  std::size_t size_ = 0;
  std::size_t size_at_rebuild_ = 0;
  bool is_lost_ = false;  // memory ran out: it looks at every sample until there is room to begin anew
  std::unordered_map<Cell, SampleSlot, CellHash> head_;  // level 0: first sample of the cell
  std::vector<std::unordered_map<Cell, std::uint32_t, CellHash>> occupied_children_;  // levels 1, 2, ...
  Table<SampleSlot, SampleSlot> next_;
  Table<SampleSlot, SampleSlot> previous_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the samples, or centres of balls, near the pointer: a hash grid over the live ones of a document.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/jobs/job_control.h"
#include "core/document/document.h"

namespace mes {

/// Adapts the samples of a document to an index.
struct SamplePlaces {
  using Row = SampleSlot;
  static std::size_t rows(const Document& document) { return document.slot_count(); }
  static std::size_t count(const Document& document) { return document.sample_count(); }
  static bool is_alive(const Document& document, SampleSlot row) { return document.is_alive(row); }
  static Vec2 place(const Document& document, SampleSlot row) { return document.position(row); }
  static const std::vector<SampleEdit>& edits(const DocumentDelta& delta) { return delta.edits; }
  static Vec2 place(Vec2 p) { return p; }
};

/// Adapts the centres of the balls of a document to an index.
struct CenterPlaces {
  using Row = BallSlot;
  static std::size_t rows(const Document& document) { return document.ball_slot_count(); }
  static std::size_t count(const Document& document) { return document.ball_count(); }
  static bool is_alive(const Document& document, BallSlot row) { return document.is_ball_alive(row); }
  static Vec2 place(const Document& document, BallSlot row) { return document.disk(row).center; }
  static const std::vector<BallEdit>& edits(const DocumentDelta& delta) { return delta.ball_edits; }
  static Vec2 place(const Disk& disk) { return disk.center; }
};

/// Guarantees:
///  1. After `follow` the answers equal those of a search through all points; ties go to the higher row.
///  2. One far outlier does not spoil the grid: the cell size comes from the middle nine tenths of the points.
///
/// Smallest use:
///     SampleIndex index(document);
///     document.apply(delta); index.follow(delta);
///     SampleSlot slot = index.nearest(cursor_world, 8 * units_per_px);
///
/// Cost: `follow` O(edits), with a rebuild whenever the number of points has changed fourfold; `nearest` looks at the
/// cells of a few rings (some microseconds at 10^6 samples); `in_box` O(cells of the box + answer). Threads: none; it
/// follows the document of the window's thread.
///
/// How it works inside: cells of level 0 hold the points as a linked list through the rows; a cell of level k + 1
/// counts the occupied ones of its 4 x 4 children, so a search in a radius of a million empty cells descends only
/// into occupied ones.
template <class Places>
class PlaceIndex {
 public:
  using Row = typename Places::Row;
  explicit PlaceIndex(const Document& document) : PlaceIndex(document, JobPart{}) {}
  /// A part of a job whose steps are the rows of several indices, in order.
  struct JobPart {
    JobControl* job = nullptr;
    std::size_t before = 0;  ///< rows of the indices made before this one
    std::size_t total = 0;   ///< rows of all indices
  };
  /// Throws `Cancelled` if there is a job and it is asked to stop.
  PlaceIndex(const Document& document, const JobPart& part);

  /// Call it after `document.apply(delta)`, with every delta, in order. Lack of memory makes searches slow, not
  /// wrong.
  void follow(const DocumentDelta& delta);
  /// Call it when the documents of both indices were swapped. O(1), without allocation.
  void swap_tables(PlaceIndex& other) noexcept;
  /// Row of the point nearest to `p` at a distance of at most `radius`, or kNoSlot.
  Row nearest(Vec2 p, double radius) const;
  /// Rows of the points in the closed box, increasing.
  std::vector<Row> in_box(const Box2& box) const;
  std::size_t size() const { return is_lost_ ? Places::count(document_) : size_; }

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
    Row slot;
    double distance = 0.0;
  };
  static constexpr std::int64_t kFanout = 4;
  static constexpr std::size_t kLevels = 24;  // 4^24 cells across: more than a double tells apart

  void rebuild(const JobPart& part);
  void rebuild() { rebuild(JobPart{}); }
  void follow_closely(const DocumentDelta& delta);
  double chosen_cell_size() const;
  Cell cell_of(Vec2 p, double size) const;
  void add(Row slot, Vec2 p);
  void remove(Row slot, Vec2 p);
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
  bool is_lost_ = false;  // memory ran out: searches look at every point until a rebuild has room
  std::unordered_map<Cell, Row, CellHash> head_;  // level 0: first point of the cell
  std::vector<std::unordered_map<Cell, std::uint32_t, CellHash>> occupied_children_;  // levels 1, 2, ...
  Table<Row, Row> next_;
  Table<Row, Row> previous_;
};

using SampleIndex = PlaceIndex<SamplePlaces>;
using CenterIndex = PlaceIndex<CenterPlaces>;
extern template class PlaceIndex<SamplePlaces>;
extern template class PlaceIndex<CenterPlaces>;

}  // namespace mes

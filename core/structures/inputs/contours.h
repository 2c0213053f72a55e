// SPDX-License-Identifier: GPL-3.0-or-later
// The contours of the document: which sample follows which on curves that came with the samples or were drawn by hand.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/table.h"
#include "core/graph/structure.h"
#include "core/structures/inputs/samples.h"

namespace mes {

using ContourSlot = Slot<struct ContourTag>;

/// One row for each *place*, a position on a contour, in the order of the contours. A place whose sample is alive has a
/// link to the next such place; the last one of a closed contour is linked to the first if it has at least three
/// corners. Samples that are not alive are skipped, and count again when they come back. A sample is never linked to
/// itself: where it follows itself, also around the end of a closed contour, it is one corner.
///
/// Cost: an edit visits the places of its samples and their neighbours, and all places of a closed contour that has
/// fewer than three corners before or after; new contours cause a rebuild, O(places).
class Contours final : public Structure {
 public:
  explicit Contours(Samples& samples);

  std::size_t row_count() const { return places_.size(); }
  bool has_link(ContourSlot row) const;
  /// The two samples of a row with a link, in the direction of the contour.
  std::pair<SampleSlot, SampleSlot> link(ContourSlot row) const;
  /// Index of its contour, from 0.
  std::uint32_t contour(ContourSlot row) const { return places_[row].contour; }
  bool is_closed(std::uint32_t contour) const { return contours_[contour].closed; }
  const ChangeSet<ContourSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  struct Place {
    SampleId id;
    SampleSlot sample;  // kNoSlot if not alive
    std::uint32_t contour = 0;
    ContourSlot next;  // for a live place, its live neighbours, cyclically
    ContourSlot previous;
  };
  struct Contour {
    std::uint32_t first = 0;
    std::uint32_t size = 0;
    std::uint32_t live = 0;
    std::uint32_t corners =
        0;             // live places followed by a different sample, the last one by the first; 0 with one sample
    ContourSlot head;  // the first live place
    bool closed = true;
  };
  template <class Visit>
  void for_each_place(SampleId id, Visit visit) const;
  void note(ContourSlot row) { recorder_.note(row, has_link(row)); }
  void note_around(ContourSlot row);
  static std::uint32_t is_step(SampleSlot from, SampleSlot to) { return from == to ? 0 : 1; }
  void become(Contour& contour, std::uint32_t corners, ContourSlot head, SampleSlot head_sample);
  void kill(ContourSlot row);
  void revive(ContourSlot row, SampleSlot sample);
  ContourSlot live_before(ContourSlot row) const;

  Samples& samples_;
  std::shared_ptr<const CurveOrder> order_;
  std::vector<Contour> contours_;
  Table<ContourSlot, Place> places_;
  std::vector<std::pair<SampleId, ContourSlot>> of_sample_;  // sorted
  Table<SampleSlot, SampleId> id_;                           // of samples on contours
  ChangeRecorder<ContourSlot> recorder_;
  ChangeSet<ContourSlot> changes_;
};

}  // namespace mes

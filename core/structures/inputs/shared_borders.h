// SPDX-License-Identifier: GPL-3.0-or-later
// Where contours of the document meet: links that they share, and other links at samples that they share.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/table.h"
#include "core/graph/structure.h"
#include "core/structures/inputs/samples.h"

namespace mes {

/// Two samples share a border if closed contours link them an even number of times, twice or more: neighbouring parcels
/// have their common side in two contours. By the even-odd rule such a side separates nothing from the outside: both of
/// its sides are inside, or neither is. Other links at a sample that closed contours pass twice are *seams*: where four
/// curves meet, angles do not tell which curves continue each other.
///
/// Guarantees:
///  1. Links skip samples that are not alive, as those of `Contours` do.
///  2. The table depends on the contours and on which samples are alive, never on history or on positions.
///  3. Nothing is stored where no sample lies on contours twice, which is the usual case.
///
/// Cost: a rebuild takes O(places on contours), also when a sample on a contour is added or removed while borders are
/// shared; any other update takes O(changed samples), a query O(log borders).
class SharedBorders final : public Structure {
 public:
  explicit SharedBorders(Samples& samples);

  bool is_empty() const { return borders_.empty() && seams_.empty(); }
  bool is_between(SampleSlot a, SampleSlot b) const { return holds(borders_, a, b); }
  bool is_seam(SampleSlot a, SampleSlot b) const { return holds(seams_, a, b); }
  const Samples& samples() const { return samples_; }
  /// True if the table differs from before the last run.
  bool has_changed() const { return has_changed_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { has_changed_ = false; }
  std::size_t touched() const override { return has_changed_ ? 1 : 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  using Link = std::pair<SampleSlot, SampleSlot>;  // the lower row first

  static bool holds(const std::vector<Link>& links, SampleSlot a, SampleSlot b);
  void find_repeated_samples();
  void find_borders(JobControl& job);

  Samples& samples_;
  std::shared_ptr<const CurveOrder> order_;
  std::vector<bool> is_repeated_;  // by id, from `first_id_` on; empty if no sample lies on closed contours twice
  std::uint32_t first_id_ = 0;
  Table<SampleSlot, SampleId> known_;  // the samples that were alive; empty if none is repeated
  std::vector<Link> seams_;            // sorted
  std::vector<Link> borders_;          // sorted
  bool has_changed_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/shared_borders.h"

#include <algorithm>

namespace mes {

SharedBorders::SharedBorders(Samples& samples) : Structure("shared-borders", {&samples}), samples_(samples) {}

bool SharedBorders::holds(const std::vector<Link>& links, SampleSlot a, SampleSlot b) {
  return std::ranges::binary_search(links, Link(std::min(a, b), std::max(a, b)));
}

// Ids of one document are consecutive, so one bit per id suffices.
void SharedBorders::find_repeated_samples() {
  is_repeated_.clear();
  std::uint32_t low = ~std::uint32_t{0};
  std::uint32_t high = 0;
  for (const CurveOrder::Contour& contour : order_->contours) {
    if (!contour.closed) continue;
    for (const SampleId id : contour.samples) {
      low = std::min(low, id.value);
      high = std::max(high, id.value);
    }
  }
  if (low > high) return;
  first_id_ = low;
  std::vector<bool> is_met(high - low + std::size_t{1});
  for (const CurveOrder::Contour& contour : order_->contours) {
    if (!contour.closed) continue;
    for (const SampleId id : contour.samples) {
      const std::size_t number = id.value - low;
      if (is_met[number]) {
        if (is_repeated_.empty()) is_repeated_.resize(is_met.size());
        is_repeated_[number] = true;
      }
      is_met[number] = true;
    }
  }
}

void SharedBorders::find_borders(JobControl& job) {
  const std::vector<Link> borders_before = std::move(borders_);
  const std::vector<Link> seams_before = std::move(seams_);
  borders_.clear();
  seams_.clear();
  known_.clear();
  if (!is_repeated_.empty()) {
    std::vector<SampleSlot> row_of(is_repeated_.size());
    for (const SampleSlot row : slots_below<SampleSlot>(samples_.row_count())) {
      const SampleId id = samples_.id(row);
      known_.push_back(id);
      if (id.is_valid() && id.value >= first_id_ && id.value - first_id_ < row_of.size())
        row_of[id.value - first_id_] = row;
    }
    std::vector<Link> links;
    std::vector<SampleSlot> corners;
    for (const CurveOrder::Contour& contour : order_->contours) {
      if (!contour.closed) continue;
      job.checkpoint();
      corners.clear();
      for (const SampleId id : contour.samples) {
        const SampleSlot row = row_of[id.value - first_id_];
        if (row != kNoSlot && (corners.empty() || row != corners.back())) corners.push_back(row);
      }
      while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
      // Two corners give the same link in both directions.
      constexpr std::size_t kLeastOfLoop = 3;
      if (corners.size() < kLeastOfLoop) continue;
      const auto is_repeated = [this](SampleSlot row) { return is_repeated_[samples_.id(row).value - first_id_]; };
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const SampleSlot from = corners[i];
        const SampleSlot to = corners[i + 1 < corners.size() ? i + 1 : 0];
        if (is_repeated(from) || is_repeated(to)) links.emplace_back(std::min(from, to), std::max(from, to));
      }
    }
    std::ranges::sort(links);
    for (std::size_t i = 0; i < links.size();) {
      std::size_t end = i + 1;
      while (end < links.size() && links[end] == links[i]) ++end;
      ((end - i) % 2 == 0 ? borders_ : seams_).push_back(links[i]);
      i = end;
    }
  }
  has_changed_ = borders_ != borders_before || seams_ != seams_before;
}

void SharedBorders::rebuild(JobControl& job) {
  order_ = samples_.curve_order_shared();
  find_repeated_samples();
  find_borders(job);
}

bool SharedBorders::update(JobControl& job) {
  if (order_ != samples_.curve_order_shared()) {
    rebuild(job);
    return true;
  }
  has_changed_ = false;
  if (is_repeated_.empty()) return true;
  const ChangeSet<SampleSlot>& changes = samples_.changes();
  const bool same = changes.removed.empty() && std::ranges::all_of(changes.touched, [this](SampleSlot row) {
                      return known_.has(row) && known_[row] == samples_.id(row);
                    });
  if (!same) find_borders(job);
  return true;
}

StatList SharedBorders::statistics() const {
  return {{"shared_links", static_cast<std::int64_t>(borders_.size())}};
}

}  // namespace mes

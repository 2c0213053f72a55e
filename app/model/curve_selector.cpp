// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/curve_selector.h"

#include <algorithm>
#include <string>

#include "core/base/job_control.h"
#include "core/evolutions/moving_curve.h"

namespace mes {

void CurveSelector::begin(Wish wish) {
  const Document& document = editor_.document();
  if (editor_.selection().sample_count() == 0) return;
  if (curve_ && curve_of_ == document.revision()) {
    select(wish);
    return;
  }
  const bool is_awaited = job_.is_under_way() && wished_at_ == document.revision();
  if (!is_awaited) wishes_.clear();
  wishes_.push_back(wish);
  if (is_awaited) return;
  wished_at_ = document.revision();
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  std::vector<Vec2> positions;
  positions.reserve(slots.size());
  for (const SampleSlot slot : slots) positions.push_back(document.position(slot));
  job_.begin([slots, positions = std::move(positions)](const std::stop_token& stop) -> std::shared_ptr<const Curve> {
    JobControl job(stop);
    const MovingCurve found = crust_curve(positions, job);
    auto out = std::make_shared<Curve>();
    for (const MovingCurve::Chain& chain : found.chains) {
      Curve::Chain& rows = out->chains.emplace_back();
      rows.closed = chain.closed;
      for (const std::uint32_t place : chain.points) rows.samples.push_back(slots[place]);
    }
    for (const auto& [follower, other] : found.followers) out->followers.emplace_back(slots[follower], slots[other]);
    return out;
  });
}

Expected<void> CurveSelector::follow() try {
  auto found = job_.poll();
  if (!found) return {};
  curve_ = *std::move(found);
  curve_of_ = wished_at_;
  const std::vector<Wish> wishes = std::exchange(wishes_, {});
  if (curve_of_ != editor_.document().revision()) return {};
  for (const Wish wish : wishes) select(wish);
  return {};
} catch (const GeometryError& problem) {
  return std::unexpected(Error{ErrorCode::cannot_compute, problem.what()});
}

void CurveSelector::select(Wish wish) {
  Selection& selection = editor_.selection();
  for (const auto& [follower, other] : curve_->followers)
    if (selection.contains(follower)) selection.add(other);
  std::vector<SampleSlot> changed;
  const bool is_added = wish != Wish::shrink;
  for (const Curve::Chain& chain : curve_->chains) {
    const std::vector<SampleSlot>& at = chain.samples;
    const auto is_selected = [&](std::size_t i) { return selection.contains(at[i]); };
    if (wish == Wish::whole) {
      if (std::ranges::any_of(at, [&](SampleSlot slot) { return selection.contains(slot); }))
        changed.insert(changed.end(), at.begin(), at.end());
      continue;
    }
    const std::size_t last = chain.closed ? at.size() : at.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      const std::size_t next = i + 1 == at.size() ? 0 : i + 1;
      if (is_selected(i) == is_selected(next)) continue;
      changed.push_back(is_selected(i) == is_added ? at[next] : at[i]);
    }
  }
  for (const SampleSlot slot : changed) {
    if (is_added)
      selection.add(slot);
    else
      selection.remove(slot);
  }
  for (const auto& [follower, other] : curve_->followers) {
    if (selection.contains(other))
      selection.add(follower);
    else if (!is_added)
      selection.remove(follower);
  }
}

}  // namespace mes

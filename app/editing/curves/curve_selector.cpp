// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/curve_selector.h"

#include <algorithm>
#include <array>

namespace mes {
namespace {

// In the order of `Wish`.
constexpr std::array<const char*, 3> kNothingChanged{"The curves of the selected samples are selected already",
                                                     "The selection has no neighbours on a curve",
                                                     "No selected sample has an unselected neighbour on a curve"};

}  // namespace

void CurveSelector::begin(Wish wish) {
  if (editor_.selection().sample_count() == 0) return;
  if (const auto* const curve = crust_.now()) {
    select(*curve, wish);
    return;
  }
  if (crust_.find()) wishes_.clear();
  wishes_.push_back(wish);
}

Expected<void> CurveSelector::follow() {
  const Expected<bool> is_found = crust_.follow();
  if (!is_found) return std::unexpected(is_found.error());
  if (!*is_found) return {};
  const std::vector<Wish> wishes = std::exchange(wishes_, {});
  if (const auto* const curve = crust_.now())
    for (const Wish wish : wishes) select(*curve, wish);
  return {};
}

void CurveSelector::select(const CrustChains::Curve& curve, Wish wish) {
  Selection& selection = editor_.selection();
  const std::vector<SampleSlot> before = selection.slots();
  for (const auto& [follower, other] : curve.followers)
    if (selection.contains(follower)) selection.add(other);
  std::vector<SampleSlot> changed;
  const bool is_added = wish != Wish::shrink;
  for (const CrustChains::Curve::Chain& chain : curve.chains) {
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
  for (const auto& [follower, other] : curve.followers) {
    if (selection.contains(other))
      selection.add(follower);
    else if (!is_added)
      selection.remove(follower);
  }
  remark_ = selection.slots() == before ? kNothingChanged[static_cast<std::size_t>(wish)]
                                        : "Selected " + counted(selection.sample_count(), selection.ball_count());
}

}  // namespace mes

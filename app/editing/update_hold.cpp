// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/update_hold.h"

#include <algorithm>

namespace mes {
namespace {

// True if the same rows are moved again, and nothing else changes, as in each step of a drag.
template <class Edits>
bool is_moved_on(const Edits& before, const Edits& after, auto kind) {
  return std::ranges::equal(before, after, [kind](const auto& a, const auto& b) {
    return a.kind == kind && b.kind == kind && a.id == b.id && a.slot == b.slot;
  });
}

bool moves_on(const DocumentDelta& before, const DocumentDelta& after) {
  const auto moves_only = [](const DocumentDelta& delta) {
    return !delta.replaces_all() && delta.curve_before == delta.curve_after && !delta.changes_annotations() &&
           !delta.changes_source();
  };
  return moves_only(before) && moves_only(after) && is_moved_on(before.edits, after.edits, SampleEdit::Kind::move) &&
         is_moved_on(before.ball_edits, after.ball_edits, BallEdit::Kind::change);
}

}  // namespace

void UpdateHold::post(std::shared_ptr<const DocumentDelta> delta) {
  if (delta->replaces_all()) set_held(false);
  if (!is_held_) {
    release();
    return listener_(std::move(delta));
  }
  if (waiting_.empty() || !moves_on(*waiting_.back(), *delta)) {
    waiting_.push_back(std::move(delta));
    return;
  }
  auto both = std::make_shared<DocumentDelta>(*delta);
  both->from_revision = waiting_.back()->from_revision;
  for (std::size_t i = 0; i < both->edits.size(); ++i) both->edits[i].from = waiting_.back()->edits[i].from;
  for (std::size_t i = 0; i < both->ball_edits.size(); ++i)
    both->ball_edits[i].from = waiting_.back()->ball_edits[i].from;
  waiting_.back() = std::move(both);
}

void UpdateHold::release() {
  for (; !waiting_.empty(); waiting_.pop_front()) listener_(waiting_.front());
}

void UpdateHold::set_held(bool held) {
  is_held_ = held;
  if (!held) release();
}

}  // namespace mes

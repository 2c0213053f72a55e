// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/history.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace mes {

namespace {

// Both lists give the same things, in the same order, new places.
template <class Edit>
bool can_merge(const std::vector<Edit>& earlier, const std::vector<Edit>& later, typename Edit::Kind kind) {
  return std::ranges::equal(earlier, later, [kind](const Edit& a, const Edit& b) {
    return a.kind == kind && b.kind == kind && a.id == b.id;
  });
}

template <class Edit>
void merge(std::vector<Edit>& earlier, const std::vector<Edit>& later) {
  for (std::size_t i = 0; i < earlier.size(); ++i) earlier[i].to = later[i].to;
}

}  // namespace

// Two deltas that move the same samples and change the same balls, in the same order, are one delta.
bool History::merge_moves(DocumentDelta& earlier, const DocumentDelta& later) {
  if (earlier.replaces_all() || later.replaces_all()) return false;
  if (earlier.curve_after != later.curve_after || earlier.curve_before != later.curve_before) return false;
  if (earlier.is_empty() || !can_merge(earlier.edits, later.edits, SampleEdit::Kind::move) ||
      !can_merge(earlier.ball_edits, later.ball_edits, BallEdit::Kind::change))
    return false;
  merge(earlier.edits, later.edits);
  merge(earlier.ball_edits, later.ball_edits);
  earlier.to_revision = later.to_revision;
  return true;
}

void History::begin_gesture(std::string name) {
  MES_ASSERT(!gesture_open_);
  gesture_open_ = true;
  gesture_ = Step{.name = std::move(name)};
}

void History::record(const DocumentDelta& delta, const std::string& name) {
  if (delta.is_empty()) return;
  steps_.resize(position_);
  if (!gesture_open_) {
    steps_.push_back({.name = name, .deltas = {delta}});
    ++position_;
    return;
  }
  if (gesture_.deltas.empty() || !merge_moves(gesture_.deltas.back(), delta)) gesture_.deltas.push_back(delta);
}

bool History::extend(const DocumentDelta& delta, const std::string& name) {
  if (gesture_open_ || position_ == 0 || position_ != steps_.size()) return false;
  Step& last = steps_.back();
  if (!last.is_edit() || last.name != name || last.deltas.back().to_revision != delta.from_revision) return false;
  return merge_moves(last.deltas.back(), delta);
}

void History::end_gesture() {
  MES_ASSERT(gesture_open_);
  gesture_open_ = false;
  if (!gesture_.is_edit() && !gesture_.layers) return;
  steps_.resize(position_);
  steps_.push_back(std::move(gesture_));
  ++position_;
}

void History::record_layers(Layers layers, const std::string& name) {
  MES_ASSERT(!gesture_open_);
  const auto undone = steps_.begin() + static_cast<std::ptrdiff_t>(position_);
  steps_.erase(std::remove_if(undone, steps_.end(), [](const Step& step) { return !step.is_edit(); }), steps_.end());
  // An edit that also showed layers is redone without them: they look as they were made to look since.
  for (std::size_t i = position_; i < steps_.size(); ++i) steps_[i].layers.reset();
  steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(position_),
                Step{.name = name, .layers = std::move(layers)});
  ++position_;
}

bool History::join_layers(Layers layers) {
  if (!gesture_open_ && position_ == 0) return false;
  Step& step = gesture_open_ ? gesture_ : steps_[position_ - 1];
  if (!step.layers) {
    step.layers = std::move(layers);
    return true;
  }
  append(step.layers->change, layers.change);
  append(layers.back, step.layers->back);
  step.layers->back = std::move(layers.back);
  return true;
}

const LayersChanged* History::layers_of_undo() const {
  if (!can_undo() || !steps_[position_ - 1].layers) return nullptr;
  return &steps_[position_ - 1].layers->back;
}

const LayersChanged* History::layers_of_redo() const {
  if (!can_redo() || !steps_[position_].layers) return nullptr;
  return &steps_[position_].layers->change;
}

std::optional<std::size_t> History::last_edit() const {
  if (gesture_open_) return std::nullopt;
  for (std::size_t i = position_; i-- > 0;)
    if (steps_[i].is_edit()) return i;
  return std::nullopt;
}

bool History::raise_edit() {
  const auto edit = last_edit();
  if (!edit) return false;
  const auto at = steps_.begin() + static_cast<std::ptrdiff_t>(*edit);
  std::rotate(at, at + 1, steps_.begin() + static_cast<std::ptrdiff_t>(position_));
  return true;
}

std::vector<DocumentDelta> History::back_of(const Step& step) {
  std::vector<DocumentDelta> out;
  out.reserve(step.deltas.size());
  for (auto delta = step.deltas.rbegin(); delta != step.deltas.rend(); ++delta) out.push_back(delta->inverted());
  return out;
}

std::vector<DocumentDelta> History::back_of_last_edit() const {
  const auto edit = last_edit();
  return edit ? back_of(steps_[*edit]) : std::vector<DocumentDelta>();
}

std::vector<DocumentDelta> History::undo() {
  if (!can_undo()) return {};
  return back_of(steps_[--position_]);
}

std::vector<DocumentDelta> History::redo() {
  if (!can_redo()) return {};
  return steps_[position_++].deltas;
}

void History::clear() {
  steps_.clear();
  position_ = 0;
  gesture_open_ = false;
  gesture_ = {};
}

}  // namespace mes

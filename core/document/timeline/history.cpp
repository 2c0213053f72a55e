// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/timeline/history.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace mes {

namespace {

// True if both lists move the same things, in the same order.
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

// Two deltas merge if they move the same samples and change the same balls, in the same order, or if both change
// annotations but not their number.
bool History::are_same_moves(const DocumentDelta& earlier, const DocumentDelta& later) {
  if (earlier.replaces_all() || later.replaces_all()) return false;
  if (earlier.curve_after != later.curve_after) return false;
  if (earlier.changes_source() || later.changes_source()) return false;
  if (later.changes_annotations())
    return later.edits.empty() && later.ball_edits.empty() && earlier.edits.empty() && earlier.ball_edits.empty() &&
           earlier.changes_annotations() && earlier.annotations_after->size() == later.annotations_after->size();
  return !earlier.is_empty() && can_merge(earlier.edits, later.edits, SampleEdit::Kind::move) &&
         can_merge(earlier.ball_edits, later.ball_edits, BallEdit::Kind::change);
}

bool History::merge_moves(DocumentDelta& earlier, const DocumentDelta& later) {
  if (!are_same_moves(earlier, later)) return false;
  merge(earlier.edits, later.edits);
  merge(earlier.ball_edits, later.ball_edits);
  earlier.annotations_after = later.annotations_after;
  earlier.to_revision = later.to_revision;
  return true;
}

void History::begin_gesture(std::string name) {
  MES_ASSERT(!gesture_open_);
  steps_.emplace_back();
  gesture_open_ = true;
  gesture_ = Step{.name = std::move(name)};
}

// Reserves the memory for `record`: room for one more delta of the gesture, or for one more step.
History::Draft::Draft(History& history, Step step, bool extends)
    : history_(history), step_(std::make_unique<Step>(std::move(step))), extends_(extends) {
  std::vector<DocumentDelta>& deltas = history.gesture_.deltas;
  if (history.gesture_open_ && deltas.size() == deltas.capacity()) deltas.reserve(2 * deltas.size() + 1);
  if (!history.gesture_open_ && !extends) history.steps_.emplace_back();
}

History::Draft::~Draft() {
  if (!is_recorded_ && !history_.gesture_open_ && !extends_) history_.steps_.pop_back();
}

void History::Draft::record() noexcept {
  MES_ASSERT(!is_recorded_);
  is_recorded_ = true;
  History& h = history_;
  if (h.gesture_open_) {
    h.steps_.erase(h.undone(), h.steps_.end() - 1);
    std::vector<DocumentDelta>& deltas = h.gesture_.deltas;
    for (DocumentDelta& delta : step_->deltas)
      if (deltas.empty() || !merge_moves(deltas.back(), delta)) deltas.push_back(std::move(delta));
    return;
  }
  if (extends_) {
    merge_moves(h.steps_.back().deltas.back(), step_->deltas.back());
    return;
  }
  // The spare entry at the end is a step without edits.
  auto rest = h.undone();
  if (!step_->is_edit()) {
    rest = std::remove_if(rest, h.steps_.end(), [](const Step& other) { return !other.is_edit(); });
    // Redo of an edit that also showed layers leaves the layers as they are now.
    for (auto undone = h.undone(); undone != rest; ++undone) undone->layers.reset();
  }
  *rest = std::move(*step_);
  h.steps_.erase(rest + 1, h.steps_.end());
  std::rotate(h.undone(), rest, h.steps_.end());
  ++h.position_;
}

History::Draft History::draft(const DocumentDelta& delta, const std::string& name, Role role) {
  Step step{.name = name, .deltas = {delta}, .is_state = role == Role::state};
  return {*this, std::move(step), role == Role::continues && can_extend(delta, name)};
}

void History::record(const DocumentDelta& delta, const std::string& name, Role role) {
  if (!delta.is_empty()) draft(delta, name, role).record();
}

bool History::can_extend(const DocumentDelta& delta, const std::string& name) const {
  // An undone step ended at a revision that is no longer the current one.
  if (gesture_open_ || steps_.empty()) return false;
  const Step& last = steps_.back();
  return last.is_edit() && last.name == name && last.deltas.back().to_revision == delta.from_revision &&
         are_same_moves(last.deltas.back(), delta);
}

bool History::extend(const DocumentDelta& delta, const std::string& name) {
  return can_extend(delta, name) && merge_moves(steps_.back().deltas.back(), delta);
}

void History::end_gesture() {
  MES_ASSERT(gesture_open_);
  gesture_open_ = false;
  if (!gesture_.is_edit() && !gesture_.layers) return steps_.pop_back();
  steps_.erase(undone(), steps_.end() - 1);
  steps_.back() = std::move(gesture_);
  ++position_;
}

History::Draft History::draft(Layers layers, const std::string& name) {
  MES_ASSERT(!gesture_open_);
  return {*this, {.name = name, .layers = std::move(layers)}, false};
}

void History::record_layers(Layers layers, const std::string& name) {
  draft(std::move(layers), name).record();
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

// While a gesture is open, the last step is only reserved for it.
const History::Step* History::newest_edit() const {
  if (gesture_open_ && gesture_.is_edit()) return &gesture_;
  for (std::size_t i = position_; i-- > 0;)
    if (steps_[i].is_edit()) return &steps_[i];
  return nullptr;
}

std::vector<DocumentDelta> History::way_before_last_edit() const {
  const Step* const edit = newest_edit();
  return edit != nullptr ? back_of(*edit) : std::vector<DocumentDelta>();
}

std::optional<std::uint64_t> History::revision_before_last_edit() const {
  const Step* const edit = newest_edit();
  return edit != nullptr ? std::optional(edit->deltas.front().from_revision) : std::nullopt;
}

bool History::last_edit_is_state() const {
  const Step* const edit = newest_edit();
  return edit != nullptr && edit->is_state;
}

void History::step_back() {
  if (can_undo()) --position_;
}

void History::step_on() {
  if (can_redo()) ++position_;
}

std::vector<DocumentDelta> History::undo() {
  std::vector<DocumentDelta> out = deltas_of_undo();
  step_back();
  return out;
}

std::vector<DocumentDelta> History::redo() {
  std::vector<DocumentDelta> out = deltas_of_redo();
  step_on();
  return out;
}

void History::clear() {
  steps_.clear();
  position_ = 0;
  gesture_open_ = false;
  gesture_ = {};
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/select_tool.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/edit/enclosed.h"

namespace mes {
namespace {

constexpr double kRadiusPerStep = 1.1;
constexpr double kLassoStepPx = 3.0;
constexpr double kHandleReachPx = 8.0;

// The text of a drag, as the window shows it beside the pointer.
std::string drag_words(Handle handle, const Dragged& result) {
  if (handle == Handle::turn) return fmt::format("{:.1f} degrees", result.degrees);
  const bool is_side = result.factor.x != result.factor.y;
  const double factor = result.factor.x == 1.0 ? result.factor.y : result.factor.x;
  const char* const coordinate = !is_side ? "" : result.factor.x == 1.0 ? "y " : "x ";
  return fmt::format("{}times {:.4g}", coordinate, factor);
}

// Ctrl counts as well because many window managers take Alt with a click for themselves.
bool asks_about(Modifiers modifiers) {
  return modifiers.ctrl || modifiers.alt;
}

}  // namespace

SelectTool::Mode SelectTool::mode_of(Modifiers modifiers) {
  if (!modifiers.shift) return Mode::replace;
  return modifiers.ctrl ? Mode::remove : Mode::add;
}

SelectTool::Hit SelectTool::pick(const Pointer& pointer) const {
  return thing_at(context_.editor.document(), context_.editor.index(), pointer.world,
                  kPickRadiusPx * pointer.units_per_px);
}

bool SelectTool::is_selected(const Hit& hit) const {
  const Selection& selection = context_.editor.selection();
  return hit.ball == kNoSlot ? selection.contains(hit.sample) : selection.contains_ball(hit.ball);
}

void SelectTool::select(const Hit& hit, Mode mode) {
  Selection& selection = context_.editor.selection();
  const bool removes = mode == Mode::remove;
  if (hit.sample != kNoSlot && removes) selection.remove(hit.sample);
  if (hit.sample != kNoSlot && !removes) selection.add(hit.sample);
  if (hit.ball != kNoSlot && removes) selection.remove_ball(hit.ball);
  if (hit.ball != kNoSlot && !removes) selection.add_ball(hit.ball);
}

Vec2 SelectTool::place_of(const Hit& hit) const {
  const Document& document = context_.editor.document();
  return hit.ball != kNoSlot ? document.disk(hit.ball).center : document.position(hit.sample);
}

ChosenThing SelectTool::chosen(const Hit& hit, const Pointer& pointer) const {
  const Vec2 place = place_of(hit);
  double away = distance(place, pointer.world);
  if (hit.ball != kNoSlot) away = std::min(away, std::abs(away - context_.editor.document().disk(hit.ball).radius));
  return {hit.ball != kNoSlot, place, away};
}

void SelectTool::select_one(const Hit& hit, Mode mode) {
  if (mode == Mode::replace) context_.editor.selection().clear();
  select(hit, mode);
}

void SelectTool::press(const Pointer& pointer) {
  wheel_px_.reset();
  start_ = now_ = pointer;
  pressed_ = pick(pointer);
  if (const auto handle = handle_at(pointer, pressed_)) {
    note_places();
    handle_ = *handle;
    handled_ = *frame_box();
    state_ = State::handling;
    return;
  }
  if (!pressed_.is_any()) {
    state_ = State::pressed_empty;
    return;
  }
  state_ = State::pressed_thing;
  const Mode mode = mode_of(pointer.modifiers);
  was_selected_ = is_selected(pressed_);
  // A press on a selected thing may begin a move of the whole selection, so it does not yet select this thing alone.
  if (mode != Mode::replace || !was_selected_) select_one(pressed_, mode);
}

void SelectTool::note_places() {
  const Document& document = context_.editor.document();
  const Selection& selection = context_.editor.selection();
  from_.clear();
  for (const SampleSlot slot : selection.slots()) from_.emplace_back(document.id(slot), document.position(slot));
  from_balls_.clear();
  for (const BallSlot slot : selection.ball_slots())
    from_balls_.emplace_back(document.ball_id(slot), document.disk(slot));
}

void SelectTool::begin_move() {
  note_places();
  context_.editor.begin_gesture("Move " + noun_of(context_.editor.selection()));
  state_ = State::moving;
}

Snapper::Except SelectTool::beside_selection() const {
  const Selection& selection = context_.editor.selection();
  return {[&selection](SampleSlot slot) { return selection.contains(slot); },
          [&selection](BallSlot slot) { return selection.contains_ball(slot); }, true};
}

std::optional<Box2> SelectTool::frame_box() const {
  const bool is_shown = context_.frame != nullptr && context_.shows_frame != nullptr && *context_.shows_frame;
  return is_shown ? context_.frame->box() : std::nullopt;
}

// Takes the handle unless the sample or ball of the hit is nearer to the pointer.
std::optional<Handle> SelectTool::handle_at(const Pointer& pointer, const Hit& hit) const {
  const auto box = frame_box();
  if (!box || pointer.modifiers.ctrl) return std::nullopt;
  double reach = kHandleReachPx * pointer.units_per_px;
  const Document& document = context_.editor.document();
  if (hit.sample != kNoSlot) reach = std::min(reach, distance(document.position(hit.sample), pointer.world));
  if (hit.ball != kNoSlot) reach = std::min(reach, distance(document.disk(hit.ball).center, pointer.world));
  return HandleFrame(*box, pointer.units_per_px).handle_at(pointer.world, reach);
}

void SelectTool::drag_handle(const Pointer& pointer) {
  if (!is_handle_dragged_)
    context_.editor.begin_gesture((handle_ == Handle::turn ? "Turn " : "Scale ") +
                                  noun_of(context_.editor.selection()));
  is_handle_dragged_ = true;
  HandleDrag drag{handle_, start_.world, pointer.world, pointer.modifiers.shift, pointer.modifiers.shift};
  if (handle_ != Handle::turn) {
    drag.from = held_place(handled_, handle_);
    drag.to = snapped(pointer, drag.from + (pointer.world - start_.world), beside_selection());
  }
  std::vector<Vec2> places;
  places.reserve(from_.size() + from_balls_.size());
  for (const auto& [id, position] : from_) places.push_back(position);
  for (const auto& [id, disk] : from_balls_) places.push_back(disk.center);
  const auto result = dragged(places, handled_, drag);
  if (!result) return;
  targets_.clear();
  for (std::size_t i = 0; i < from_.size(); ++i) targets_.emplace_back(from_[i].first, result->places[i]);
  ball_targets_.clear();
  for (std::size_t i = 0; i < from_balls_.size(); ++i)
    ball_targets_.emplace_back(from_balls_[i].first, Disk{result->places[from_.size() + i],
                                                          result->radius_factor * from_balls_[i].second.radius});
  handle_words_ = drag_words(handle_, *result);
  accepted(context_.editor.move(targets_, ball_targets_, {}));
}

std::optional<FrameMark> SelectTool::frame_mark() const {
  if (state_ == State::moving || state_ == State::boxing || state_ == State::lassoing) return std::nullopt;
  const auto box = frame_box();
  if (!box) return std::nullopt;
  return state_ == State::handling ? FrameMark{*box, handle_, handle_words_} : FrameMark{*box, hovered_handle_, {}};
}

void SelectTool::drag(const Pointer& pointer) {
  now_ = pointer;
  const bool is_far = distance(pointer.px, start_.px) > kDragThresholdPx;
  if (state_ == State::pressed_empty && is_far) {
    state_ = start_.modifiers.ctrl && !start_.modifiers.shift ? State::lassoing : State::boxing;
    lasso_.assign(1, start_.world);
    lasso_px_ = start_.px;
  }
  if (state_ == State::lassoing && distance(pointer.px, lasso_px_) >= kLassoStepPx) {
    lasso_.push_back(pointer.world);
    lasso_px_ = pointer.px;
  }
  if (state_ == State::handling && (is_far || is_handle_dragged_)) drag_handle(pointer);
  if (state_ == State::pressed_thing && is_far && is_selected(pressed_)) begin_move();
  if (state_ != State::moving) return;
  const Vec2 offset = snapped_offset(pointer);
  const Document& document = context_.editor.document();
  // The pressed thing takes the snap position itself; adding an offset would round it.
  const auto target = [&](Vec2 position, bool is_pressed) {
    return is_pressed && snap_ ? snap_->place : position + offset;
  };
  const bool holds_ball = pressed_.ball != kNoSlot;
  const SampleId sample = holds_ball ? SampleId() : document.id(pressed_.sample);
  const BallId ball = holds_ball ? document.ball_id(pressed_.ball) : BallId();
  targets_.clear();
  for (const auto& [id, position] : from_) targets_.emplace_back(id, target(position, id == sample));
  ball_targets_.clear();
  for (const auto& [id, disk] : from_balls_)
    ball_targets_.emplace_back(id, Disk{target(disk.center, id == ball), disk.radius});
  accepted(context_.editor.move(targets_, ball_targets_, {}));
}

// Shifts the pressed thing onto its snap target; the rest of the selection moves by the same offset.
Vec2 SelectTool::snapped_offset(const Pointer& pointer) {
  const Vec2 offset = pointer.world - start_.world;
  const Document& document = context_.editor.document();
  const auto find = [](const auto& list, auto id) {
    return std::ranges::find(list, id, [](const auto& entry) { return entry.first; });
  };
  Vec2 from;
  if (pressed_.ball != kNoSlot) {
    const auto ball = find(from_balls_, document.ball_id(pressed_.ball));
    if (ball == from_balls_.end()) return offset;
    from = ball->second.center;
  } else {
    const auto sample = find(from_, document.id(pressed_.sample));
    if (sample == from_.end()) return offset;
    from = sample->second;
  }
  const Vec2 to = snapped(pointer, from + offset, beside_selection());
  return snap_ ? to - from : offset;
}

void SelectTool::select_box(const Pointer& pointer) {
  Box2 box;
  box.add(start_.world);
  box.add(pointer.world);
  const Mode mode = mode_of(pointer.modifiers);
  if (mode == Mode::replace) context_.editor.selection().clear();
  for (const SampleSlot slot : context_.editor.index().in_box(box)) select({slot, kNoSlot}, mode);
  for (const BallSlot slot : balls_in_box(context_.editor.document(), box)) select({kNoSlot, slot}, mode);
}

void SelectTool::select_lasso(const Pointer& pointer) {
  // Ctrl began the lasso; with Shift the lasso adds to the selection, as a box does.
  const Mode mode = pointer.modifiers.shift ? Mode::add : Mode::replace;
  if (mode == Mode::replace) context_.editor.selection().clear();
  Box2 box;
  for (const Vec2 corner : lasso_) box.add(corner);
  const Document& document = context_.editor.document();
  for (const SampleSlot slot : context_.editor.index().in_box(box))
    if (encloses(lasso_, document.position(slot))) select({slot, kNoSlot}, mode);
  for (const BallSlot slot : balls_in_box(document, box))
    if (encloses(lasso_, document.disk(slot).center)) select({kNoSlot, slot}, mode);
}

void SelectTool::release(const Pointer& pointer) {
  drag(pointer);
  const Mode mode = mode_of(pointer.modifiers);
  switch (state_) {
    case State::idle: break;
    case State::pressed_empty:
      if (mode == Mode::replace) context_.editor.selection().clear();
      if (mode == Mode::replace && context_.ask_about) context_.ask_about(pointer);
      break;
    case State::pressed_thing:
      if (mode == Mode::replace && was_selected_) select_one(pressed_, mode);
      if (mode == Mode::replace && !asks_about(pointer.modifiers) && context_.note_chosen)
        context_.note_chosen(pointer, chosen(pressed_, pointer));
      if (mode == Mode::replace && asks_about(pointer.modifiers) && context_.ask_about) context_.ask_about(pointer);
      break;
    case State::boxing: select_box(pointer); break;
    case State::lassoing: select_lasso(pointer); break;
    case State::handling:
      if (std::exchange(is_handle_dragged_, false)) context_.editor.end_gesture();
      handle_words_.clear();
      snap_.reset();
      break;
    case State::moving:
      context_.editor.end_gesture();
      snap_.reset();
      break;
  }
  state_ = State::idle;
  hover(pointer);
}

void SelectTool::cancel() {
  if (state_ == State::moving || std::exchange(is_handle_dragged_, false)) context_.editor.cancel_gesture();
  handle_words_.clear();
  snap_.reset();
  state_ = State::idle;
}

bool SelectTool::wheel(const Pointer& pointer, double steps) {
  if (is_active()) return false;
  if (context_.editor.selection().ball_count() == 0) wheel_px_.reset();
  // Turning the wheel moves the circle away from the pointer; the following turns still belong to this ball.
  const bool continues = wheel_px_.has_value();
  if (!continues) {
    const Hit hit = pick(pointer);
    if (hit.ball == kNoSlot || !is_selected(hit)) return false;
    wheel_px_ = pointer.px;
  }
  accepted(context_.editor.scale_selected_balls(std::pow(kRadiusPerStep, steps), pointer.units_per_px, continues));
  return true;
}

void SelectTool::hover(const Pointer& pointer) {
  if (wheel_px_ && distance(*wheel_px_, pointer.px) > kDragThresholdPx) wheel_px_.reset();
  now_ = pointer;
  hovered_ = pick(pointer);
  hovered_handle_ = handle_at(pointer, hovered_);
  if (hovered_handle_) hovered_ = {};
}

void SelectTool::leave() {
  hovered_ = {};
  hovered_handle_.reset();
  wheel_px_.reset();
}

ToolFeedback SelectTool::feedback() const {
  ToolFeedback out;
  const bool holds_thing = state_ == State::pressed_thing || state_ == State::moving;
  const Hit shown = holds_thing ? pressed_ : hovered_;
  if (state_ == State::boxing) {
    out.box_px.emplace();
    out.box_px->add(start_.px);
    out.box_px->add(now_.px);
    return out;
  }
  if (state_ == State::lassoing) {
    out.lasso = lasso_;
    out.lasso.push_back(now_.world);
    return out;
  }
  out.snap = snap_;
  out.frame = frame_mark();
  const Document& document = context_.editor.document();
  if (document.is_alive(shown.sample)) out.hovered = shown.sample;
  if (document.is_ball_alive(shown.ball)) out.hovered_ball = shown.ball;
  out.asks =
      state_ == State::idle && !shown.is_any() && !hovered_handle_ && context_.ask_about && !now_.modifiers.shift;
  return out;
}

PointerShape SelectTool::pointer_shape() const {
  const bool holds = state_ == State::moving || state_ == State::handling;
  return holds || (state_ == State::idle && (hovered_.is_any() || hovered_handle_)) ? PointerShape::hand
                                                                                    : PointerShape::arrow;
}

}  // namespace mes

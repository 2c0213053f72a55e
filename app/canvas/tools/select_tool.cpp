// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/select_tool.h"

#include <cmath>

#include "app/model/ball_pick.h"

namespace mes {
namespace {

constexpr double kRadiusPerStep = 1.1;

// Many window managers take Alt with a click for themselves.
bool asks_about(Modifiers modifiers) {
  return modifiers.ctrl || modifiers.alt;
}

}  // namespace

SelectTool::Mode SelectTool::mode_of(Modifiers modifiers) {
  if (!modifiers.shift) return Mode::replace;
  return modifiers.ctrl ? Mode::remove : Mode::add;
}

SelectTool::Hit SelectTool::pick(const Pointer& pointer) const {
  const double reach = kPickRadiusPx * pointer.units_per_px;
  const Document& document = context_.editor.document();
  const SampleSlot sample = context_.editor.index().nearest(pointer.world, reach);
  if (sample == kNoSlot) return {kNoSlot, nearest_ball(document, pointer.world, reach).slot};
  // A ball must be nearer than the sample: samples lie on circles more often than beside them.
  const double to_sample = distance(document.position(sample), pointer.world);
  const BallPick ball = nearest_ball(document, pointer.world, to_sample);
  if (ball.slot != kNoSlot && ball.distance < to_sample) return {kNoSlot, ball.slot};
  return {sample, kNoSlot};
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

void SelectTool::select_one(const Hit& hit, Mode mode) {
  if (mode == Mode::replace) context_.editor.selection().clear();
  select(hit, mode);
}

void SelectTool::press(const Pointer& pointer) {
  wheel_px_.reset();
  start_ = now_ = pointer;
  pressed_ = pick(pointer);
  if (!pressed_.is_any()) {
    state_ = State::pressed_empty;
    return;
  }
  state_ = State::pressed_thing;
  const Mode mode = mode_of(pointer.modifiers);
  was_selected_ = is_selected(pressed_);
  // A press on something selected may begin a move of all that is, so it does not yet select this one alone.
  if (mode != Mode::replace || !was_selected_) select_one(pressed_, mode);
}

void SelectTool::begin_move() {
  const Document& document = context_.editor.document();
  const Selection& selection = context_.editor.selection();
  from_.clear();
  for (const SampleSlot slot : selection.slots()) from_.emplace_back(document.id(slot), document.position(slot));
  from_balls_.clear();
  for (const BallSlot slot : selection.ball_slots())
    from_balls_.emplace_back(document.ball_id(slot), document.disk(slot));
  context_.editor.begin_gesture("Move " + noun_of(selection));
  state_ = State::moving;
}

void SelectTool::drag(const Pointer& pointer) {
  now_ = pointer;
  const bool is_far = distance(pointer.px, start_.px) > kDragThresholdPx;
  if (state_ == State::pressed_empty && is_far) state_ = State::boxing;
  if (state_ == State::pressed_thing && is_far && is_selected(pressed_)) begin_move();
  if (state_ != State::moving) return;
  const Vec2 offset = pointer.world - start_.world;
  targets_.clear();
  for (const auto& [id, position] : from_) targets_.emplace_back(id, position + offset);
  ball_targets_.clear();
  for (const auto& [id, disk] : from_balls_) ball_targets_.emplace_back(id, Disk{disk.center + offset, disk.radius});
  accepted(context_.editor.move(targets_, ball_targets_, {}));
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
      if (mode == Mode::replace && asks_about(pointer.modifiers) && context_.ask_about) context_.ask_about(pointer);
      break;
    case State::boxing: select_box(pointer); break;
    case State::moving: context_.editor.end_gesture(); break;
  }
  state_ = State::idle;
  hover(pointer);
}

void SelectTool::cancel() {
  if (state_ == State::moving) context_.editor.cancel_gesture();
  state_ = State::idle;
}

bool SelectTool::wheel(const Pointer& pointer, double steps) {
  if (is_active()) return false;
  if (context_.editor.selection().ball_count() == 0) wheel_px_.reset();
  // While the wheel is turned the circle moves away from the pointer; the turns go on meaning this ball.
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
}

void SelectTool::leave() {
  hovered_ = {};
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
  const Document& document = context_.editor.document();
  if (document.is_alive(shown.sample)) out.hovered = shown.sample;
  if (document.is_ball_alive(shown.ball)) out.hovered_ball = shown.ball;
  out.asks = state_ == State::idle && !shown.is_any() && context_.ask_about && !now_.modifiers.shift;
  return out;
}

PointerShape SelectTool::pointer_shape() const {
  return state_ == State::moving || (state_ == State::idle && hovered_.is_any()) ? PointerShape::hand
                                                                                 : PointerShape::arrow;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/select_tool.h"

#include <algorithm>

namespace mes {

SelectTool::Mode SelectTool::mode_of(Modifiers modifiers) {
  if (!modifiers.shift) return Mode::replace;
  return modifiers.ctrl ? Mode::remove : Mode::add;
}

Slot SelectTool::pick(const Pointer& pointer) const {
  return context_.editor.index().nearest(pointer.world, kPickRadiusPx * pointer.units_per_px);
}

void SelectTool::select_one(Slot slot, Mode mode) {
  Selection& selection = context_.editor.selection();
  if (mode == Mode::remove) {
    selection.remove(slot);
    return;
  }
  if (mode == Mode::replace) selection.clear();
  selection.add(slot);
}

void SelectTool::press(const Pointer& pointer) {
  start_ = now_ = pointer;
  pressed_ = pick(pointer);
  if (pressed_ == kNoSlot) {
    state_ = State::pressed_empty;
    return;
  }
  state_ = State::pressed_sample;
  const Mode mode = mode_of(pointer.modifiers);
  was_selected_ = context_.editor.selection().contains(pressed_);
  // A press on a selected sample may begin a move of them all, so it does not yet select this one alone.
  if (mode != Mode::replace || !was_selected_) select_one(pressed_, mode);
}

void SelectTool::begin_move() {
  const Document& document = context_.editor.document();
  from_.clear();
  for (const Slot slot : context_.editor.selection().slots())
    from_.emplace_back(document.id(slot), document.position(slot));
  context_.editor.begin_gesture(from_.size() == 1 ? "Move sample" : "Move samples");
  state_ = State::moving;
}

void SelectTool::drag(const Pointer& pointer) {
  now_ = pointer;
  const bool is_far = distance(pointer.px, start_.px) > kDragThresholdPx;
  if (state_ == State::pressed_empty && is_far) state_ = State::boxing;
  if (state_ == State::pressed_sample && is_far && context_.editor.selection().contains(pressed_)) begin_move();
  if (state_ != State::moving) return;
  const Vec2 offset = pointer.world - start_.world;
  targets_.clear();
  for (const auto& [id, position] : from_) targets_.emplace_back(id, position + offset);
  accepted(context_.editor.move(targets_, {}));
}

void SelectTool::select_box(const Pointer& pointer) {
  Box2 box;
  box.add(start_.world);
  box.add(pointer.world);
  const Mode mode = mode_of(pointer.modifiers);
  Selection& selection = context_.editor.selection();
  if (mode == Mode::replace) selection.clear();
  for (const Slot slot : context_.editor.index().in_box(box)) {
    if (mode == Mode::remove)
      selection.remove(slot);
    else
      selection.add(slot);
  }
}

void SelectTool::release(const Pointer& pointer) {
  drag(pointer);
  const Mode mode = mode_of(pointer.modifiers);
  switch (state_) {
    case State::idle: break;
    case State::pressed_empty:
      if (mode == Mode::replace) context_.editor.selection().clear();
      break;
    case State::pressed_sample:
      if (mode == Mode::replace && was_selected_) select_one(pressed_, mode);
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

void SelectTool::hover(const Pointer& pointer) {
  now_ = pointer;
  hovered_ = pick(pointer);
}

ToolFeedback SelectTool::feedback() const {
  ToolFeedback out;
  const bool holds_sample = state_ == State::pressed_sample || state_ == State::moving;
  out.hovered = holds_sample ? pressed_ : hovered_;
  if (state_ == State::boxing) {
    out.hovered = kNoSlot;
    out.box_px.emplace();
    out.box_px->add(start_.px);
    out.box_px->add(now_.px);
  }
  if (!context_.editor.document().is_alive(out.hovered)) out.hovered = kNoSlot;
  return out;
}

PointerShape SelectTool::pointer_shape() const {
  return state_ == State::moving || (state_ == State::idle && hovered_ != kNoSlot) ? PointerShape::hand
                                                                                   : PointerShape::arrow;
}

}  // namespace mes

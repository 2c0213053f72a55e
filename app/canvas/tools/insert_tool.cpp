// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/insert_tool.h"

#include <array>

namespace mes {

void InsertTool::press(const Pointer& pointer) {
  context_.editor.begin_gesture("Insert sample");
  const std::array<Vec2, 1> position{snapped(pointer, pointer.world, beside_samples(false))};
  const auto slots = context_.editor.insert(position, {});
  if (!accepted(slots)) {
    context_.editor.end_gesture();
    return;
  }
  sample_ = context_.editor.document().id(slots->front());
  pressed_px_ = pointer.px;
  pressed_snap_ = snap_;
  pointer_px_ = pointer.px;
}

void InsertTool::drag(const Pointer& pointer) {
  if (!is_active()) return;
  pointer_px_ = pointer.px;
  // After a click the sample stays where it was snapped, even on a Voronoi vertex that the new sample has destroyed.
  if (distance(pointer.px, pressed_px_) > kDragThresholdPx) pressed_snap_.reset();
  if (pressed_snap_) {
    snap_ = pressed_snap_;
    return;
  }
  const std::array<std::pair<SampleId, Vec2>, 1> target{
      {{sample_, snapped(pointer, pointer.world, beside_samples(true))}}};
  accepted(context_.editor.move(target, {}));
}

void InsertTool::release(const Pointer& pointer) {
  if (!is_active()) return;
  drag(pointer);
  context_.editor.end_gesture();
  sample_ = {};
}

void InsertTool::cancel() {
  if (!is_active()) return;
  context_.editor.cancel_gesture();
  sample_ = {};
}

ToolFeedback InsertTool::feedback() const {
  ToolFeedback out;
  out.marker_px = pointer_px_;
  out.snap = snap_;
  return out;
}

}  // namespace mes

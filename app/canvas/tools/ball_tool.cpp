// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/ball_tool.h"

#include <array>

namespace mes {
namespace {

bool is_too_small(double radius, const Pointer& pointer) {
  return !(radius > kDragThresholdPx * pointer.units_per_px);
}

}  // namespace

void BallTool::press(const Pointer& pointer) {
  center_ = snapped(pointer, pointer.world, {});
  radius_ = 0.0;
  ball_ = {};
  pointer_px_ = pointer.px;
  context_.editor.begin_gesture("Insert ball");
}

void BallTool::drag(const Pointer& pointer) {
  if (!is_active()) return;
  pointer_px_ = pointer.px;
  const auto is_this = [this](BallSlot slot) { return context_.editor.document().ball_id(slot) == ball_; };
  radius_ = distance(*center_, snapped(pointer, pointer.world, {.ball = is_this}));
  if (ball_.is_valid()) {
    const std::array<std::pair<BallId, Disk>, 1> target{{{ball_, {*center_, radius_}}}};
    accepted(context_.editor.move({}, target, {}));
  } else if (!is_too_small(radius_, pointer)) {
    const std::array<Disk, 1> disk{{{*center_, radius_}}};
    const auto slots = context_.editor.insert_balls(disk, {});
    if (!accepted(slots))
      cancel();
    else
      ball_ = context_.editor.document().ball_id(slots->front());
  }
}

void BallTool::release(const Pointer& pointer) {
  if (!is_active()) return;
  drag(pointer);
  if (!is_active()) return;
  if (is_too_small(radius_, pointer)) {
    cancel();
    return;
  }
  context_.editor.end_gesture();
  center_.reset();
}

void BallTool::cancel() {
  if (!is_active()) return;
  context_.editor.cancel_gesture();
  center_.reset();
}

ToolFeedback BallTool::feedback() const {
  ToolFeedback out;
  out.marker_px = pointer_px_;
  out.snap = snap_;
  if (is_active() && ball_.is_valid()) out.ball = Disk{*center_, radius_};
  return out;
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pointer_marks.h"

#include "app/ui/theme.h"

namespace mes {
namespace {

// ImGui draws circles as polygons of corners all around; a far too large one is left to its layer.
constexpr double kLargestCirclePx = 10'000.0;
constexpr float kRing = 9.0F;

/// Draws marks at places of the world and of the canvas.
class Pen {
 public:
  explicit Pen(const PointerMarks& marks)
      : canvas_(marks.canvas),
        list_(*ImGui::GetBackgroundDrawList()),
        unit_(marks.gui.unit()),
        color_(marks.color),
        ink_(to_imgui(marks.color)) {}

  void ring(Vec2 world) const { list_.AddCircle(at(to_px(world)), kRing * unit_, ink_, 0, 2.0F * unit_); }
  void dot(Vec2 world) const { list_.AddCircleFilled(at(to_px(world)), 3.0F * unit_, ink_); }
  void circle(const Disk& disk, float width) const {
    const double radius = disk.radius / (canvas_.content_scale() * canvas_.view().camera().units_per_pixel());
    if (radius < kLargestCirclePx)
      list_.AddCircle(at(to_px(disk.center)), static_cast<float>(radius) * unit_, ink_, 0, width * unit_);
  }
  void line(Vec2 world, Vec2 px) const { list_.AddLine(at(to_px(world)), at(px), ink_, unit_); }
  void box(const Box2& px) const {
    list_.AddRectFilled(at(px.low), at(px.high), to_imgui(color_, 0.13));
    list_.AddRect(at(px.low), at(px.high), ink_, 0.0F, 0, unit_);
  }
  void faint_ring(Vec2 px, double radius_px) const {
    list_.AddCircle(at(px), static_cast<float>(radius_px) * unit_, to_imgui(color_, 0.56), 0, 1.2F * unit_);
  }

 private:
  Vec2 to_px(Vec2 world) const { return (1.0 / canvas_.content_scale()) * canvas_.view().camera().to_screen(world); }
  ImVec2 at(Vec2 px) const { return {static_cast<float>(px.x) * unit_, static_cast<float>(px.y) * unit_}; }

  const Canvas& canvas_;
  ImDrawList& list_;
  float unit_;
  Rgb color_;
  ImU32 ink_;
};

}  // namespace

void PointerMarks::draw() const {
  const ToolFeedback feedback = canvas.tool().feedback();
  const Pen pen(*this);
  if (feedback.hovered != kNoSlot && document.is_alive(feedback.hovered))
    pen.ring(document.position(feedback.hovered));
  if (document.is_ball_alive(feedback.hovered_ball)) {
    const Disk& disk = document.disk(feedback.hovered_ball);
    pen.circle(disk, 2.0F);
    pen.ring(disk.center);
  }
  if (feedback.ball) {
    pen.circle(*feedback.ball, 1.5F);
    pen.dot(feedback.ball->center);
    if (feedback.marker_px) pen.line(feedback.ball->center, *feedback.marker_px);
  }
  if (feedback.box_px) pen.box(*feedback.box_px);
  if (feedback.marker_px && feedback.ring_px > 0.0) pen.faint_ring(*feedback.marker_px, feedback.ring_px);
}

}  // namespace mes

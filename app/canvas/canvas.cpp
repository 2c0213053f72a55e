// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/canvas.h"

#include <cmath>
#include <utility>

#include "app/canvas/tools/annotate_tool.h"
#include "app/canvas/tools/ball_tool.h"
#include "app/canvas/tools/brush_tool.h"
#include "app/canvas/tools/insert_tool.h"
#include "app/canvas/tools/measure_tool.h"
#include "app/canvas/tools/select_tool.h"
#include "app/canvas/tools/spray_tool.h"

namespace mes {
namespace {

constexpr double kZoomPerStep = 1.2;

}  // namespace

Canvas::Canvas(ToolContext& context)
    : tools_{std::make_unique<SelectTool>(context),  std::make_unique<InsertTool>(context),
             std::make_unique<SprayTool>(context),   std::make_unique<BallTool>(context),
             std::make_unique<MeasureTool>(context), std::make_unique<AnnotateTool>(context),
             std::make_unique<BrushTool>(context)} {}

Pointer Canvas::pointer(Vec2 px, Modifiers modifiers) const {
  return {(1.0 / content_scale_) * px, view_at_pointer().camera().to_world(px),
          content_scale_ * view_at_pointer().camera().units_per_pixel(), modifiers};
}

void Canvas::set_panes(PanePlaces panes) {
  if (panes == panes_) return;
  panes_ = std::move(panes);
  if (pane_ >= panes_.places().size()) pane_ = 0;
}

Vec2 Canvas::in_main_pane(Vec2 px) {
  if (!has_pointer()) pane_ = panes_.at(px);
  return px - pane_shift();
}

void Canvas::press(PointerButton button, Vec2 in_window, Modifiers modifiers) {
  const Vec2 px = in_main_pane(in_window);
  move_to(px, modifiers);
  if (has_pointer()) return;
  if (button != PointerButton::left || space_held_) {
    panning_ = true;
    pan_button_ = button;
    if (button == PointerButton::right) right_press_ = px;
    return;
  }
  tool().press(pointer(px, modifiers));
}

void Canvas::move(Vec2 px, Modifiers modifiers) {
  move_to(in_main_pane(px), modifiers);
}

void Canvas::move_to(Vec2 px, Modifiers modifiers) {
  const Vec2 delta = px - right_press_.value_or(pointer_px_);
  pointer_px_ = px;
  modifiers_ = modifiers;
  is_hovered_ = true;
  // A click of the right button leaves the view as it is.
  if (right_press_ && length(delta) <= kDragThresholdPx * content_scale_) return;
  right_press_.reset();
  if (panning_)
    view_at_pointer().pan(delta);
  else if (tool().is_active())
    tool().drag(pointer(px, modifiers));
  else
    tool().hover(pointer(px, modifiers));
}

bool Canvas::release(PointerButton button, Vec2 in_window, Modifiers modifiers) {
  const Vec2 px = in_main_pane(in_window);
  if (panning_) {
    move_to(px, modifiers);
    if (button != pan_button_) return false;
    panning_ = false;
    return std::exchange(right_press_, {}).has_value();
  }
  if (button != PointerButton::left || !tool().is_active()) return false;
  pointer_px_ = px;
  tool().release(pointer(px, modifiers));
  return false;
}

void Canvas::wheel(Vec2 in_window, double steps) {
  const Vec2 px = in_main_pane(in_window);
  if (!panning_ && tool().wheel(pointer(px, modifiers_), steps)) return;
  view_at_pointer().zoom_at(px, std::pow(kZoomPerStep, steps));
}

void Canvas::leave() {
  is_hovered_ = false;
  for (const auto& tool : tools_) tool->leave();
}

void Canvas::set_space_held(bool held) {
  space_held_ = held;
}

bool Canvas::cancel_gesture() {
  if (!has_pointer()) return false;
  panning_ = false;
  right_press_.reset();
  tool().cancel();
  return true;
}

void Canvas::clear_all_tools() {
  for (const auto& tool : tools_) tool->clear();
}

void Canvas::choose_tool(ToolId chosen) {
  if (chosen == tool_id_ || tool().is_active()) return;
  tool().leave();
  tool_id_ = chosen;
  if (is_hovered_) tool().hover(pointer(pointer_px_, modifiers_));
}

PointerShape Canvas::pointer_shape() const {
  return panning_ || space_held_ ? PointerShape::hand : tool().pointer_shape();
}

void Canvas::follow_view() {
  if (panning_ || !is_hovered_) return;
  if (tool().is_active())
    tool().drag(pointer(pointer_px_, modifiers_));
  else
    tool().hover(pointer(pointer_px_, modifiers_));
}

void Canvas::advance(double seconds) {
  const bool moved = view_at_pointer().is_moving();
  views_.advance(seconds);
  if (moved) follow_view();
}

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/marks/mark_drag.h"

#include <cmath>

#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr double kSnapPx = 8.0;      // logical pixels
constexpr float kUnsteadyPx = 3.0F;  // movement of a hand that clicks

ImVec2 corner_on_screen(const MarkDrag::Mark& mark, Vec2 px, float unit) {
  return {std::round(mark.origin.x + static_cast<float>(px.x) * unit),
          std::round(mark.origin.y + static_cast<float>(px.y) * unit)};
}

}  // namespace

bool MarkDrag::follow(const Gui& gui, const Mark& mark, std::optional<PaperPlace>& place) {
  const float unit = gui.unit();
  const ImVec2 low = corner_on_screen(mark, mark.box.low, unit);
  const ImVec2 high = corner_on_screen(mark, mark.box.high, unit);
  const SplitterMove move = drag_handle(gui, mark.id, {low, {high.x - low.x, high.y - low.y}}, mark.explanation,
                                        "Back to its own position");
  if (move.is_reset) place.reset();
  if (!move.is_dragged) {
    if (held_ && held_->id == mark.id) held_.reset();
    return false;
  }
  if (!held_) held_ = {mark.id, mark.box.low, place};
  held_->is_drawn = true;
  if (held_->is_cancelled) {
    place = held_->before;
    return true;
  }
  // Measured from where the button was pressed, because a late frame may have missed a part of the movement.
  const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, kUnsteadyPx * unit);
  if (way.x == 0.0F && way.y == 0.0F) return true;
  const Vec2 moved{static_cast<double>(way.x / unit), static_cast<double>(way.y / unit)};
  place = place_of(held_->corner + moved, mark.box.high - mark.box.low, mark.room, kSnapPx);
  return true;
}

// A mark that is no longer drawn is no longer held either.
void MarkDrag::end_frame() {
  if (held_ && !held_->is_drawn) held_.reset();
  if (held_) held_->is_drawn = false;
}

bool MarkDrag::cancel() {
  if (!is_under_way()) return false;
  held_->is_cancelled = true;
  return true;
}

}  // namespace mes

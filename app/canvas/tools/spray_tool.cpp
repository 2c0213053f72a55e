// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/spray_tool.h"

#include <algorithm>
#include <array>

namespace mes {

void SprayTool::press(const Pointer& pointer) {
  context_.editor.begin_gesture("Spray");
  const std::array<Vec2, 1> position{pointer.world};
  active_ = accepted(context_.editor.insert(position, {}));
  if (!active_) context_.editor.end_gesture();
  last_ = pointer;
  pointer_px_ = pointer.px;
  since_sample_px_ = 0.0;
}

void SprayTool::drag(const Pointer& pointer) {
  if (!active_) return;
  pointer_px_ = pointer.px;
  const double step = std::max(1.0, context_.spray_spacing_px);
  const double way = distance(last_.px, pointer.px);
  std::vector<Vec2> positions;
  double next = step - since_sample_px_;
  for (; next <= way; next += step) positions.push_back(last_.world + (next / way) * (pointer.world - last_.world));
  since_sample_px_ = way - (next - step);
  last_ = pointer;
  if (!positions.empty()) accepted(context_.editor.insert(positions, {}));
}

void SprayTool::release(const Pointer& pointer) {
  if (!active_) return;
  drag(pointer);
  context_.editor.end_gesture();
  active_ = false;
}

void SprayTool::cancel() {
  if (!active_) return;
  context_.editor.cancel_gesture();
  active_ = false;
}

ToolFeedback SprayTool::feedback() const {
  ToolFeedback out;
  out.marker_px = pointer_px_;
  out.ring_px = context_.spray_spacing_px;
  return out;
}

}  // namespace mes

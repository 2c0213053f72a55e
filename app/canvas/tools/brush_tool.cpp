// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/brush_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mes {
namespace {

struct ModeWords {
  const char* step;
  std::string_view hint;
};
constexpr std::array<ModeWords, kBrushModes> kWords{
    {{"Erase", "Drag to erase samples, and balls at their centres"},
     {"Thin out", "Drag to remove every other sample along the curve"},
     {"Refine", "Drag to insert a sample between neighbours along the curve"}}};

const ModeWords& words_of(BrushMode mode) {
  return kWords[static_cast<std::size_t>(mode)];
}

}  // namespace

std::string_view BrushTool::hint() const {
  return words_of(context_.brush->mode).hint;
}

void BrushTool::touch(const Pointer& pointer) {
  accepted(stroke_->touch(pointer.world, context_.brush->radius_px * pointer.units_per_px, context_.brush->mode));
  last_ = pointer;
}

void BrushTool::press(const Pointer& pointer) {
  context_.editor.begin_gesture(words_of(context_.brush->mode).step);
  stroke_.emplace(context_.editor);
  pointer_px_ = pointer.px;
  touch(pointer);
}

void BrushTool::drag(const Pointer& pointer) {
  if (!is_active()) return;
  pointer_px_ = pointer.px;
  // When erasing, steps of a quarter of the radius leave hardly any gap at the rim. The other modes have to find the
  // curve, which takes longer, and gaps at the rim do not matter there.
  const double share = context_.brush->mode == BrushMode::erase ? 0.25 : 0.5;
  const double step = std::max(1.0, share * context_.brush->radius_px);
  const Pointer from = last_;
  const double way = distance(from.px, pointer.px);
  for (double passed = step; passed <= way; passed += step) {
    Pointer at = pointer;
    at.px = from.px + (passed / way) * (pointer.px - from.px);
    at.world = from.world + (passed / way) * (pointer.world - from.world);
    touch(at);
  }
}

void BrushTool::release(const Pointer& pointer) {
  if (!is_active()) return;
  drag(pointer);
  if (last_.px != pointer.px) touch(pointer);
  accepted(stroke_->finish());
  context_.editor.end_gesture();
  stroke_.reset();
}

void BrushTool::cancel() {
  if (!is_active()) return;
  context_.editor.cancel_gesture();
  stroke_.reset();
}

ToolFeedback BrushTool::feedback() const {
  ToolFeedback out;
  out.marker_px = pointer_px_;
  out.ring_px = context_.brush->radius_px;
  return out;
}

}  // namespace mes

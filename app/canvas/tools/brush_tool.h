// SPDX-License-Identifier: GPL-3.0-or-later
// Drag to erase samples, to thin them out, or to make them denser along the curve.
#pragma once

#include "app/canvas/tools/tool.h"
#include "app/editing/tools/brush.h"

namespace mes {

/// Guarantees: a stroke touches everything that the ring passes over, however few positions of the pointer the system
/// reports.
class BrushTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return stroke_.has_value(); }
  bool is_stroke() const override { return true; }
  void hover(const Pointer& pointer) override { pointer_px_ = pointer.px; }
  void leave() override { pointer_px_.reset(); }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override { return PointerShape::crosshair; }
  std::string_view hint() const override;

 private:
  void touch(const Pointer& pointer);

  std::optional<BrushStroke> stroke_;
  Pointer last_;
  std::optional<Vec2> pointer_px_;
};

}  // namespace mes

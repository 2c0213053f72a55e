// SPDX-License-Identifier: GPL-3.0-or-later
// Drag to draw a stroke of samples, evenly spaced along the path of the pointer.
#pragma once

#include "app/canvas/tools/tool.h"

namespace mes {

/// Guarantees: neighbouring samples of a stroke are `spray_spacing_px` apart along the polygon of the pointer's
/// positions, however few of them the system reports.
class SprayTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return active_; }
  bool is_stroke() const override { return true; }
  void hover(const Pointer& pointer) override { pointer_px_ = pointer.px; }
  void leave() override { pointer_px_.reset(); }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override { return PointerShape::crosshair; }
  std::string_view hint() const override { return "Drag to draw a stroke of samples"; }

 private:
  bool active_ = false;
  Pointer last_;
  double since_sample_px_ = 0.0;
  std::optional<Vec2> pointer_px_;
};

}  // namespace mes

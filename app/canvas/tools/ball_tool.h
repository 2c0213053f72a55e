// SPDX-License-Identifier: GPL-3.0-or-later
// Press at the centre of a ball and drag to its circle; the ball follows from the first pixels on.
#pragma once

#include "app/canvas/tools/tool.h"

namespace mes {

/// Guarantees: a ball ends on the pointer, and is one step. A click, or a drag that returns to its start, makes
/// nothing: a ball too small to see would only be in the way.
class BallTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return center_.has_value(); }
  void hover(const Pointer& pointer) override {
    pointer_px_ = pointer.px;
    snapped(pointer, pointer.world, {});
  }
  void leave() override {
    pointer_px_.reset();
    snap_.reset();
  }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override { return PointerShape::crosshair; }
  std::string_view hint() const override { return "Press at the centre of a ball and drag to its circle"; }

 private:
  std::optional<Vec2> center_;  // centre of the ball being drawn
  BallId ball_;                 // valid once the ball is large enough
  double radius_ = 0.0;
  std::optional<Vec2> pointer_px_;
};

}  // namespace mes

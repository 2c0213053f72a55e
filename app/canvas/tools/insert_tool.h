// SPDX-License-Identifier: GPL-3.0-or-later
// Click to add a sample; while the button is down the new sample stays under the pointer.
#pragma once

#include "app/canvas/tools/tool.h"

namespace mes {

class InsertTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return sample_.is_valid(); }
  void hover(const Pointer& pointer) override {
    pointer_px_ = pointer.px;
    snapped(pointer, pointer.world, beside_samples(false));
  }
  void leave() override {
    pointer_px_.reset();
    snap_.reset();
  }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override { return PointerShape::crosshair; }
  std::string_view hint() const override { return "Click to add a sample; hold the button down to position it"; }

 private:
  /// Excludes samples as snap targets: a sample on top of another one would change nothing.
  static Snapper::Except beside_samples(bool is_placed) {
    return {.sample = [](SampleSlot) { return true; }, .vertices = is_placed};
  }

  SampleId sample_;
  Vec2 pressed_px_;
  std::optional<Snap> pressed_snap_;  ///< the snap of the press, until the pointer moves away
  std::optional<Vec2> pointer_px_;
};

}  // namespace mes

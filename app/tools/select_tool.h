// SPDX-License-Identifier: GPL-3.0-or-later
// Click and box to select; drag a sample to move it, with the selection it belongs to.
#pragma once

#include <utility>
#include <vector>

#include "app/tools/tool.h"

namespace mes {

class SelectTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return state_ != State::idle; }
  void hover(const Pointer& pointer) override;
  void leave() override { hovered_ = kNoSlot; }
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override;
  std::string_view hint() const override { return "Drag a sample to move it; drag empty space to select with a box"; }

 private:
  enum class State : std::uint8_t {
    idle,
    pressed_sample,  ///< a click, until the pointer moves away
    pressed_empty,
    moving,
    boxing,
  };
  enum class Mode : std::uint8_t { replace, add, remove };
  static Mode mode_of(Modifiers modifiers);

  void begin_move();
  void select_one(Slot slot, Mode mode);
  void select_box(const Pointer& pointer);
  Slot pick(const Pointer& pointer) const;

  State state_ = State::idle;
  Pointer start_;
  Pointer now_;
  Slot pressed_ = kNoSlot;
  bool was_selected_ = false;
  Slot hovered_ = kNoSlot;
  std::vector<std::pair<SampleId, Vec2>> from_;     // where the moved samples were
  std::vector<std::pair<SampleId, Vec2>> targets_;  // kept for its memory
};

}  // namespace mes

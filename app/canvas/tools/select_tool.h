// SPDX-License-Identifier: GPL-3.0-or-later
// Click, box or lasso to select; drag a sample or a ball to move it together with the selection it belongs to; drag a
// handle of the frame to scale, mirror or turn the selection; turn the wheel on a selected ball to change its radius.
#pragma once

#include <utility>
#include <vector>

#include "app/canvas/tools/tool.h"
#include "app/editing/places/ball_pick.h"

namespace mes {

/// A ball can be picked at its centre or its circle, and a box or lasso contains it when it contains its centre. When
/// both a sample and a ball can be picked, the nearer one is. All turns of the wheel until the pointer moves on are
/// one step.
class SelectTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return state_ != State::idle; }
  bool is_stroke() const override {
    return state_ == State::lassoing || (state_ == State::pressed_empty && start_.modifiers.ctrl);
  }
  bool wheel(const Pointer& pointer, double steps) override;
  void hover(const Pointer& pointer) override;
  void leave() override;
  ToolFeedback feedback() const override;
  PointerShape pointer_shape() const override;
  std::string_view hint() const override {
    return "Drag a sample or a ball to move it; drag empty space to select with a box, with Ctrl held with a lasso";
  }

 private:
  enum class State : std::uint8_t {
    idle,
    pressed_thing,  ///< a click on a sample or a ball, until the pointer moves away
    pressed_empty,
    moving,
    handling,  ///< a handle of the frame is held
    boxing,
    lassoing,
  };
  enum class Mode : std::uint8_t { replace, add, remove };
  static Mode mode_of(Modifiers modifiers);
  using Hit = PickedThing;  // the thing under the pointer

  void begin_move();
  bool is_selected(const Hit& hit) const;
  void select(const Hit& hit, Mode mode);
  void select_one(const Hit& hit, Mode mode);
  Vec2 snapped_offset(const Pointer& pointer);
  /// Notes the present positions of the selected things.
  void note_places();
  Snapper::Except beside_selection() const;
  std::optional<Box2> frame_box() const;
  std::optional<Handle> handle_at(const Pointer& pointer, const Hit& hit) const;
  void drag_handle(const Pointer& pointer);
  std::optional<FrameMark> frame_mark() const;
  void select_box(const Pointer& pointer);
  void select_lasso(const Pointer& pointer);
  Hit pick(const Pointer& pointer) const;
  Vec2 place_of(const Hit& hit) const;
  ChosenThing chosen(const Hit& hit, const Pointer& pointer) const;

  State state_ = State::idle;
  Pointer start_;
  Pointer now_;
  Hit pressed_;
  bool was_selected_ = false;
  Hit hovered_;
  std::optional<Vec2> wheel_px_;  // pointer position while the wheel is being turned on balls
  std::vector<Vec2> lasso_;       // corners in the world
  Vec2 lasso_px_;                 // its last corner on the canvas
  std::optional<Handle> hovered_handle_;
  Handle handle_ = Handle::turn;  // the handle that is held
  Box2 handled_;                  // the box when the handle was pressed
  bool is_handle_dragged_ = false;
  std::string handle_words_;
  std::vector<std::pair<SampleId, Vec2>> from_;  // the moved samples and their positions before
  std::vector<std::pair<BallId, Disk>> from_balls_;
  std::vector<std::pair<SampleId, Vec2>> targets_;  // kept to reuse its memory
  std::vector<std::pair<BallId, Disk>> ball_targets_;
};

}  // namespace mes

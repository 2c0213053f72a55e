// SPDX-License-Identifier: GPL-3.0-or-later
// The plane under the pointer: pans and zooms by itself, and hands all other events to the tool in use.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/actions/pointer_input.h"
#include "app/canvas/tools/tool.h"
#include "app/panes/pane_places.h"
#include "app/panes/pane_views.h"

namespace mes {

enum class ToolId : std::uint8_t { select, insert, spray, ball, measure, annotate, brush };
inline constexpr std::size_t kToolCount = 7;

/// Guarantees: from press to release one gesture has the pointer, whatever else is pressed meanwhile. The view may
/// move during a tool's gesture, which then follows the pointer. Positions are framebuffer pixels. The class depends
/// on no window and no OpenGL. Threads: none.
class Canvas {
 public:
  explicit Canvas(ToolContext& context);

  /// The view of the main pane.
  ViewMotion& view() { return views_.main(); }
  const ViewMotion& view() const { return views_.main(); }
  /// The views of all panes.
  PaneViews& views() { return views_; }
  const PaneViews& views() const { return views_; }
  /// The view of the pane that the pointer is in, or was in last.
  ViewMotion& view_at_pointer() { return views_.of(pane_); }
  const ViewMotion& view_at_pointer() const { return views_.of(pane_); }
  /// Framebuffer pixels per logical pixel.
  void set_content_scale(double scale) { content_scale_ = scale; }
  double content_scale() const { return content_scale_; }

  /// Sets the panes. The pointer meets the plane as the pane under it shows it; a gesture stays in the pane where
  /// it began.
  void set_panes(PanePlaces panes);
  const PanePlaces& panes() const { return panes_; }
  /// The pane that the pointer is in, and the shift from the main pane to it in pixels.
  std::size_t pane() const { return pane_; }
  Vec2 pane_shift() const { return panes_.shift(pane_); }

  void press(PointerButton button, Vec2 in_window, Modifiers modifiers);
  void move(Vec2 px, Modifiers modifiers);
  /// Returns true if it ended a click of the right button, which has panned nothing.
  bool release(PointerButton button, Vec2 in_window, Modifiers modifiers);
  /// Turns the wheel by `steps`, positive away from the user. Zooms, unless the tool takes the event.
  void wheel(Vec2 in_window, double steps);
  void leave();
  void set_space_held(bool held);
  /// Ends the gesture under way without its effect; false when there was none.
  bool cancel_gesture();

  /// True while a gesture has the pointer: events belong to the canvas wherever the pointer moves.
  bool has_pointer() const { return panning_ || tool().is_active(); }
  bool is_hovered() const { return is_hovered_; }
  /// The corresponding point of the main pane.
  Vec2 pointer_px() const { return pointer_px_; }
  Vec2 pointer_world() const { return view_at_pointer().camera().to_world(pointer_px_); }
  /// The pointer if it is here, else the middle of the free area: the point around which keys zoom the view.
  Vec2 zoom_center() const { return is_hovered_ ? pointer_px_ : view_at_pointer().middle(); }

  /// The pointer as tools see it.
  Pointer pointer() const { return pointer(pointer_px_, modifiers_); }
  /// The same at `zoom_center`, for keys.
  Pointer pointer_for_keys() const { return pointer(zoom_center(), modifiers_); }

  /// Discards what the tool in use shows between gestures; returns false if it showed nothing.
  bool clear_tool() { return tool().clear(); }
  /// The same for all tools, when another document replaces this one.
  void clear_all_tools();
  void choose_tool(ToolId tool);
  ToolId tool_id() const { return tool_id_; }
  Tool& tool() { return *tools_[static_cast<std::size_t>(tool_id_)]; }
  const Tool& tool() const { return *tools_[static_cast<std::size_t>(tool_id_)]; }
  PointerShape pointer_shape() const;

  /// Moves the view on; the element under a resting pointer may change with it.
  void advance(double seconds);

 private:
  Pointer pointer(Vec2 px, Modifiers modifiers) const;
  Vec2 in_main_pane(Vec2 px);
  void move_to(Vec2 px, Modifiers modifiers);
  void follow_view();

  PaneViews views_;
  PanePlaces panes_;
  std::size_t pane_ = 0;
  std::array<std::unique_ptr<Tool>, kToolCount> tools_;
  ToolId tool_id_ = ToolId::select;
  double content_scale_ = 1.0;
  Vec2 pointer_px_{};
  Modifiers modifiers_;
  bool is_hovered_ = false;
  bool space_held_ = false;
  bool panning_ = false;
  PointerButton pan_button_ = PointerButton::middle;
  std::optional<Vec2> right_press_;  // position of a press that is still a click of the right button
};

}  // namespace mes

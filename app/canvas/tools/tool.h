// SPDX-License-Identifier: GPL-3.0-or-later
// A tool turns pointer events on the canvas into commands.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/actions/key_chord.h"
#include "app/actions/pointer_input.h"
#include "app/editing/editor.h"
#include "app/editing/selection_frame.h"
#include "app/editing/tools/annotation_editor.h"
#include "app/editing/tools/brush_settings.h"
#include "app/editing/tools/snapper.h"
#include "core/base/geometry/box2.h"
#include "core/edit/frame_handles.h"

namespace mes {

/// The position of the pointer. Pixels are logical, y down; the world is that of the document, y up.
struct Pointer {
  Vec2 px{};
  Vec2 world{};
  double units_per_px = 1.0;
  Modifiers modifiers{};
};

inline constexpr BrushSettings kUsualBrush{};

/// A sample, or a ball that was picked at its circle or centre.
struct ChosenThing {
  bool is_ball = false;
  Vec2 place{};           ///< position of the sample, or centre of the ball
  double distance = 0.0;  ///< distance from the pointer to the sample, or to the circle or centre
};

/// The objects that a tool works with. They all outlive the tool.
struct ToolContext {
  Editor& editor;
  AnnotationEditor& annotations;
  const double& spray_spacing_px;
  std::function<void(const Error&)> report;         ///< called when a command is refused
  std::function<void(const Pointer&)> ask_about{};  ///< called to ask what lies there and where it comes from
  /// Returns the annotation drawn at a position in logical pixels, if any.
  std::function<std::optional<std::size_t>(Vec2)> annotation_at{};
  const Snapper* snapper = nullptr;  ///< null: no snapping
  const BrushSettings* brush = &kUsualBrush;
  const SelectionFrame* frame = nullptr;  ///< null: the selection has no handles
  const bool* shows_frame = nullptr;      ///< set together with `frame`
  /// Called when a click there has selected this thing alone.
  std::function<void(const Pointer&, const ChosenThing&)> note_chosen{};
};

/// The frame around the selection.
struct FrameMark {
  Box2 box{};                     ///< bounding box of the positions; the frame is drawn around it
  std::optional<Handle> taken{};  ///< the handle that a press would take, or that is held
  std::string words{};            ///< effect of the drag; empty between drags
};

/// Additional marks that the canvas shows for a tool besides the drawing.
struct ToolFeedback {
  SampleSlot hovered;                           ///< the sample a press would take
  BallSlot hovered_ball;                        ///< the ball a press would take; never set together with `hovered`
  bool asks = false;                            ///< a click would ask what lies here
  std::optional<Disk> ball;                     ///< a ball being drawn
  std::optional<Box2> box_px;                   ///< the selection box being drawn
  std::vector<Vec2> lasso{};                    ///< the lasso being drawn, in the world
  std::optional<Vec2> marker_px;                ///< position where a press would put a sample
  double ring_px = 0.0;                         ///< radius of a circle around the marker; 0 = none
  std::vector<Vec2> measured{};                 ///< the points in the world being measured
  std::optional<std::size_t> annotation{};      ///< the annotation a press would take
  std::optional<Vec2> ringed{};                 ///< position in the world of the element that a press would attach to
  std::optional<std::pair<Vec2, Vec2>> line{};  ///< the line being drawn, in the world
  std::optional<Snap> snap{};                   ///< the snap that replaces the pointer's position
  std::optional<FrameMark> frame{};
};

/// The distance in logical pixels within which a position snaps.
inline constexpr double kSnapReachPx = 8.0;

/// Guarantees: a tool holds only the state of a gesture; between gestures it holds the last position of the pointer
/// and what `clear` discards. A gesture is at most one step of undo. `cancel` takes it back. Threads: the window's.
class Tool {
 public:
  explicit Tool(ToolContext& context) : context_(context) {}
  virtual ~Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  virtual void press(const Pointer& pointer) = 0;
  /// The pointer moved with the button down, or the view moved under it.
  virtual void drag(const Pointer& pointer) = 0;
  virtual void release(const Pointer& pointer) = 0;
  virtual void cancel() = 0;
  virtual bool is_active() const = 0;
  /// True if every position that the pointer passes counts, not only its position once per frame.
  virtual bool is_stroke() const { return false; }
  /// Discards what the tool shows between gestures; returns false if it showed nothing.
  virtual bool clear() { return false; }

  /// The wheel was turned, positive away from the user; false when the tool has no use for it and the view zooms.
  virtual bool wheel(const Pointer& /*pointer*/, double /*steps*/) { return false; }
  /// The pointer moved with no button down.
  virtual void hover(const Pointer& pointer) = 0;
  /// The pointer left the canvas.
  virtual void leave() = 0;
  virtual ToolFeedback feedback() const = 0;
  /// The present measurement as an annotation; nothing for other tools, and before there are two points.
  virtual std::optional<Annotation> measurement() const { return std::nullopt; }
  virtual PointerShape pointer_shape() const = 0;
  /// Instructions for the tool, one line for the status bar.
  virtual std::string_view hint() const = 0;

 protected:
  template <class T>
  bool accepted(const Expected<T>& result) {
    if (!result && context_.report) context_.report(result.error());
    return result.has_value();
  }
  /// Returns the position, or the one it snaps to; holding Ctrl switches snapping off.
  Vec2 snapped(const Pointer& pointer, Vec2 place, const Snapper::Except& except) {
    snap_.reset();
    if (context_.snapper != nullptr && !pointer.modifiers.ctrl)
      snap_ = context_.snapper->at(place, kSnapReachPx * pointer.units_per_px, except);
    return snap_ ? snap_->place : place;
  }
  ToolContext& context_;
  std::optional<Snap> snap_;
};

/// The distance in logical pixels within which the pointer takes a sample.
inline constexpr double kPickRadiusPx = 9.0;
/// The distance in logical pixels that the pointer must move before a click becomes a drag.
inline constexpr double kDragThresholdPx = 3.0;

}  // namespace mes

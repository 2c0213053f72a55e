// SPDX-License-Identifier: GPL-3.0-or-later
// A tool turns what the pointer does on the canvas into commands.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/actions/key_chord.h"
#include "app/editing/annotation_desk.h"
#include "app/editing/brush_settings.h"
#include "app/editing/editor.h"
#include "app/editing/selection_frame.h"
#include "app/editing/snapper.h"
#include "core/base/box2.h"
#include "core/edit/frame_handles.h"

namespace mes {

/// Where the pointer is. Pixels are logical, y down; the world is that of the document, y up.
struct Pointer {
  Vec2 px{};
  Vec2 world{};
  double units_per_px = 1.0;
  Modifiers modifiers{};
};

inline constexpr BrushSettings kUsualBrush{};

/// A sample, or a ball that was taken by its circle or centre.
struct ChosenThing {
  bool is_ball = false;
  Vec2 place{};           ///< its own, or its centre
  double distance = 0.0;  ///< from the pointer to the sample, or to circle or centre
};

/// What a tool works with. Everything outlives the tool.
struct ToolContext {
  Editor& editor;
  AnnotationDesk& annotations;
  const double& spray_spacing_px;
  std::function<void(const Error&)> report;         ///< a command was refused
  std::function<void(const Pointer&)> ask_about{};  ///< what lies there, and where does it come from?
  /// The annotation that is drawn at a place in logical pixels; nothing where none is.
  std::function<std::optional<std::size_t>(Vec2)> annotation_at{};
  const Snapper* snapper = nullptr;  ///< none: places are where the pointer is
  const BrushSettings* brush = &kUsualBrush;
  const SelectionFrame* frame = nullptr;  ///< none: the selection has no handles
  const bool* shows_frame = nullptr;      ///< with `frame`
  /// A click there selected it alone.
  std::function<void(const Pointer&, const ChosenThing&)> note_chosen{};
};

/// The frame around what is selected.
struct FrameMark {
  Box2 box{};                     ///< around the places; the frame goes around it
  std::optional<Handle> taken{};  ///< that a press would take, or that is held
  std::string words{};            ///< what the drag does; empty between drags
};

/// What the canvas shows of a tool besides the drawing.
struct ToolFeedback {
  SampleSlot hovered;                           ///< the sample a press would take
  BallSlot hovered_ball;                        ///< the ball it would take; never both
  bool asks = false;                            ///< a click would ask what lies here
  std::optional<Disk> ball;                     ///< a ball being drawn
  std::optional<Box2> box_px;                   ///< the selection box being drawn
  std::vector<Vec2> lasso{};                    ///< in the world, being drawn around what is to be selected
  std::optional<Vec2> marker_px;                ///< where a press would put a sample
  double ring_px = 0.0;                         ///< radius of a circle around the marker; 0 = none
  std::vector<Vec2> measured{};                 ///< places in the world between which something is measured
  std::optional<std::size_t> annotation{};      ///< that a press would take
  std::optional<Vec2> ringed{};                 ///< the place in the world of an element that a press would be on
  std::optional<std::pair<Vec2, Vec2>> line{};  ///< in the world, being drawn
  std::optional<Snap> snap{};                   ///< where a place is put instead of under the pointer
  std::optional<FrameMark> frame{};
};

enum class PointerShape : std::uint8_t { arrow, crosshair, hand };

/// How near a place must be to what it snaps to, in logical pixels.
inline constexpr double kSnapReachPx = 8.0;

/// What it guarantees: a tool holds the state of a gesture and nothing else; between gestures it holds only where the
/// pointer last was, and what `clear` discards. A gesture is at most one step of undo. `cancel` takes it back.
/// Threads: the window's.
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
  /// Each place that the pointer passes counts, not only where it is once a frame.
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
  /// What it measures, as an annotation; nothing for other tools, and before there are two places.
  virtual std::optional<Annotation> measurement() const { return std::nullopt; }
  virtual PointerShape pointer_shape() const = 0;
  /// What to do with it, one line for the status bar.
  virtual std::string_view hint() const = 0;

 protected:
  template <class T>
  bool accepted(const Expected<T>& result) {
    if (!result && context_.report) context_.report(result.error());
    return result.has_value();
  }
  /// The place, or what it snaps to; Ctrl holds that off.
  Vec2 snapped(const Pointer& pointer, Vec2 place, const Snapper::Except& except) {
    snap_.reset();
    if (context_.snapper != nullptr && !pointer.modifiers.ctrl)
      snap_ = context_.snapper->at(place, kSnapReachPx * pointer.units_per_px, except);
    return snap_ ? snap_->place : place;
  }
  ToolContext& context_;
  std::optional<Snap> snap_;
};

/// How near the pointer must be to a sample to take it, in logical pixels.
inline constexpr double kPickRadiusPx = 9.0;
/// How far the pointer moves before a click becomes a drag.
inline constexpr double kDragThresholdPx = 3.0;

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Distributes the events of the window: first to the panels, then to the canvas, then to the table of actions.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/panels/on_canvas/marks/mark_drag.h"
#include "app/panels/on_canvas/presenter.h"
#include "app/window/event_queue.h"
#include "app/window/files/document_flow.h"
#include "app/window/runs/experiment_run.h"
#include "app/window/runs/live_recording.h"

namespace mes {

/// Guarantees: events are handled in order, each by its intended target. Events that arrived together with one that
/// opened or closed a dialog wait for the next frame. During a recording each event waits until the previous change
/// has its frame; so does the key that ends it, but a second press ends it at once. A key without effect gives the
/// reason. Ctrl, Shift and Alt held for a gesture take no key's action away. Listens to the window for its whole life.
/// Threads: the window's.
class WindowInput final : private WindowListener {
 public:
  struct Uses {
    Screen& screen;
    Canvas& canvas;
    const Selection& selection;
    const AnnotationEditor& annotations;
    Dialogs& dialogs;
    DocumentFlow& documents;
    ExperimentRun& experiments;
    const LiveRecording& recording;
    const ActionBindings& actions;
    Messages& messages;
    Presenter& presenter;
    MarkDrag& mark_drag;
    std::function<void()> open_menu;                        ///< opens the menu of a right click on the canvas
    std::function<bool(std::ptrdiff_t rows)> step_in_list;  ///< returns false if no list is under the pointer
    std::function<void()> follow_hold;                      ///< holds or releases the update; called after each event
  };
  explicit WindowInput(const Uses& uses);
  ~WindowInput() override;

  /// Called once per turn: handles the events that have arrived.
  void deliver();
  bool has_waiting_events() const { return !events_.is_empty(); }
  /// True if a key that holds the update, Alt or `kHoldKey`, was down at the event handled last.
  bool is_update_held() const { return is_alt_held_ || is_hold_key_held_; }
  /// Last position of the pointer, in framebuffer pixels.
  Vec2 pointer_px() const { return pointer_px_; }

 private:
  using Clock = std::chrono::steady_clock;
  void on_pointer_moved(Vec2 px, Modifiers modifiers) override;
  void on_pointer_left() override;
  void on_button(PointerButton button, bool pressed, Modifiers modifiers) override;
  void on_wheel(double steps) override;
  void on_key(const KeyChord& chord, bool repeated) override;
  void on_typed(char32_t symbol, bool repeated) override;
  void on_space(bool held) override;
  void on_key_held(char32_t symbol, bool held) override;
  void on_modifiers(Modifiers modifiers) override;
  void on_files_dropped(std::vector<std::string> files) override;
  void on_close_wanted() override;
  void on_anything() override { uses_.screen.clock.settle(); }
  void follow_pointer(Vec2 px, Modifiers modifiers);
  void press(PointerButton button, Vec2 px, Modifiers modifiers);
  void release(PointerButton button, Vec2 px, Modifiers modifiers, Clock::time_point when);
  void run_by_key(const KeyChord& chord, bool repeated);
  /// True while a button of the mouse is down for the canvas, or for a control of a panel.
  bool is_in_gesture() const;
  std::optional<ActionId> action_of(const KeyChord& chord) const;
  /// Handles a key while a list or a field has the keyboard. Returns true if it is consumed, or will be delivered
  /// again.
  bool is_for_panels(const KeyChord& chord, bool repeated);
  /// Delivers the key again in the next frame, when the list or field is closed.
  void come_again(const KeyChord& chord, bool repeated);
  bool is_refused_by_gesture(ActionId action);
  /// Arrow keys and Delete are not for the drawing while the pointer is on a panel that was clicked, such as a list.
  bool is_refused_on_panel(ActionId action);
  /// Arrow keys move the choice in a list that was clicked. Returns false if there is none.
  bool steps_in_list(const KeyChord& chord);

  Uses uses_;
  EventQueue events_;
  Vec2 pointer_px_{-1, -1};
  Vec2 pressed_px_{-1, -1};
  struct Click {
    Clock::time_point when;
    int frame = 0;
    Vec2 px{};
  };
  std::optional<Click> click_;     // the last click on the canvas
  bool waits_for_panels_ = false;  // a press may give a field the keyboard, and a release may end a control's drag
  bool is_panel_pressed_ = false;  // a button of the mouse went down over the panels
  bool is_on_panel_ = false;       // the last press was on a panel, and the pointer has not left it since
  bool has_come_again_ = false;    // the present key was delivered again
  bool ends_recording_ = false;    // such a key is waiting in the queue
  bool is_alt_held_ = false;
  bool is_hold_key_held_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Events of the window: panels have first refusal, then the canvas, then the table of actions.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/panels/mark_drag.h"
#include "app/panels/presenter.h"
#include "app/window/document_flow.h"
#include "app/window/event_queue.h"
#include "app/window/experiment_run.h"
#include "app/window/live_recording.h"

namespace mes {

/// What it guarantees: events are acted on in their order, each by what it was meant for. What came together with an
/// event that opened or closed a dialog waits for the next frame, and during a recording each event waits until the
/// change before has its frame; the key that ends it does as well, and ends it at once when it is pressed again. A key
/// that does nothing says why. Listens to the window for its life. Threads: the window's.
class WindowInput final : private WindowListener {
 public:
  struct Uses {
    Screen& screen;
    Canvas& canvas;
    const Selection& selection;
    const AnnotationDesk& annotations;
    Dialogs& dialogs;
    DocumentFlow& documents;
    ExperimentRun& experiments;
    const LiveRecording& recording;
    const ActionBindings& actions;
    Messages& messages;
    Presenter& presenter;
    MarkDrag& mark_drag;
  };
  explicit WindowInput(const Uses& uses);
  ~WindowInput() override;

  /// Once a turn: acts on what has come.
  void deliver();
  bool has_waiting_events() const { return !events_.is_empty(); }
  /// The key that holds the update is down (`kHoldKey`).
  bool is_update_held() const { return is_update_held_; }
  /// Where the pointer was last, in framebuffer pixels.
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
  std::optional<ActionId> action_of(const KeyChord& chord) const;
  /// A key for which a list or a field has the keyboard. True: it is not for the canvas, or comes once more.
  bool is_for_panels(const KeyChord& chord, bool repeated);
  /// It is acted on in the next frame, when what was closed is gone.
  void come_again(const KeyChord& chord, bool repeated);
  bool is_refused_by_gesture(ActionId action);

  Uses uses_;
  EventQueue events_;
  Vec2 pointer_px_{-1, -1};
  Vec2 pressed_px_{-1, -1};
  struct Click {
    Clock::time_point when;
    int frame = 0;
    Vec2 px{};
  };
  std::optional<Click> click_;     // the last one on the canvas
  bool waits_for_panels_ = false;  // a press may give the keyboard to a field
  bool has_come_again_ = false;    // the key that is acted on
  bool ends_recording_ = false;    // a key that does so waits for its turn
  bool is_update_held_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// The window program: its parts, and the loop that draws a frame when something has changed and sleeps otherwise.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/settings/settings_file.h"
#include "app/system/termination.h"
#include "app/system/waker.h"
#include "app/ui/screen/screen.h"
#include "app/window/files/document_flow.h"
#include "app/window/key_bindings.h"
#include "app/window/panels.h"
#include "app/window/run_window.h"
#include "app/window/runs/demo_run.h"
#include "app/window/runs/experiment_run.h"
#include "app/window/runs/lesson_run.h"
#include "app/window/runs/link_run.h"
#include "app/window/runs/live_recording.h"
#include "app/window/window_input.h"
#include "app/window/work/drawing_board.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: those of its members; and with nothing new to show it sleeps and uses no processor time.
///
/// Threads: the main one. Each member uses those above it and none below. They are destroyed in reverse order: first
/// the listeners of events, then the users of OpenGL, then the engine with its thread, and the window last.
class App {
 public:
  App(LiveRegistry registry, std::unique_ptr<GlfwWindow> window, const WindowOptions& options, LoadedSettings loaded);

  /// Runs until the user has left or a signal asks for it.
  void run(const Termination& termination);
  /// One turn of `run`, which waits for an event unless a frame is wanted. False: the user has left, and `end` is due.
  bool step();
  /// A frame is wanted without an event.
  bool wants_turn() const;
  /// Whether a panel or a dialog lies there, in screen coordinates.
  bool is_on_panel(Vec2 at) const;
  /// Seconds until a turn is needed without an event; 0: without limit.
  double next_wait();
  /// Writes the settings while the window goes on, as `end` does.
  void keep_settings();
  /// The same for settings and unsaved work; waits for the latter.
  void keep();
  /// Saves the settings and closes what is under way.
  void end();

 private:
  App(LiveRegistry registry, std::unique_ptr<GlfwWindow> window, const std::filesystem::path& assets,
      LoadedSettings loaded);
  void bind_actions();
  void deselect();
  bool clear_selection();
  bool cancel_lesson_export();
  bool end_lesson();
  void wait_for_event();
  void turn();
  void follow_hold();
  void take_results();
  void deliver_events();
  void refuse_for_memory() noexcept;
  void frame();
  void take_steps();
  void draw();
  void update_title();

  Waker wake_;
  SettingsFile settings_;
  Messages messages_;
  Screen screen_;
  Workspace work_;
  DrawingBoard board_;
  DemoRun demo_;
  LessonRun lesson_;
  LiveRecording recording_;
  Dialogs dialogs_;
  DocumentFlow documents_;
  ExperimentRun experiments_;
  LinkRun link_;
  KeyBindings keys_;
  Panels panels_;
  WindowInput input_;
  int turns_at_rest_ = 0;   // consecutive turns at rest
  std::uint64_t said_ = 0;  // number of messages that have had their frames
  bool is_held_by_key_ = false;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Recording follows what the window shows; see window_recorder.h.
#pragma once

#include <filesystem>
#include <functional>

#include "app/actions/action_bindings.h"
#include "app/recording/window_recorder.h"
#include "app/settings/settings.h"
#include "app/window/runs/demo_run.h"
#include "app/window/runs/lesson_run.h"
#include "app/window/work/drawing_board.h"

namespace mes {

/// Calls per turn of the window's loop, in this order: `note_if_complete`, take results, draw the drawing,
/// `picture_drawn`, draw the panels, `panels_drawn`, swap the window, `follow`.
/// Threads: the window's; `wake` is called from others.
class LiveRecording {
 public:
  struct Uses {
    Screen& screen;
    const Workspace& work;
    DrawingBoard& board;
    const DemoRun& demo;
    const LessonRun& lesson;
    const Settings& settings;
    Messages& messages;
  };
  LiveRecording(Uses uses, const std::filesystem::path& assets, std::function<void()> wake);

  WindowRecorder& recorder() { return recorder_; }
  const WindowRecorder& recorder() const { return recorder_; }
  void bind(ActionBindings& actions);

  /// True while a change waits for its frame; other input must wait until then.
  bool holds_input() const;
  bool holds_motion() const { return recorder_.holds_motion(shown_state()); }
  void note_if_complete(bool is_reading);
  /// `marks`: of the window, in this frame.
  void picture_drawn(const MarkPlaces& marks) { recorder_.picture_drawn(drawn(marks)); }
  void panels_drawn() { recorder_.panels_drawn(drawn({})); }
  void follow();
  void end() { recorder_.end(); }

 private:
  void start(const RecordSettings& settings);
  ShownState shown_state() const;
  AtRest at_rest() const;
  std::vector<std::string> labels_of_panes() const;
  WindowRecorder::Drawn drawn(const MarkPlaces& marks) const;

  Uses uses_;
  WindowRecorder recorder_;
};

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Presents the steps of a lesson in the editor, where they can be edited, and restores everything afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/playing/lesson_walk.h"
#include "core/io/session/session.h"

namespace mes {

/// Guarantees:
///  1. During the presentation the editor holds the samples of a step, which can be edited like any others. The
///     previous content of the editor, with its history and its timeline, is put aside, and `end` restores it
///     exactly.
///  2. A step shows the samples, layers, settings and view that `LessonWalk` gives, whatever was done before; only
///     with `keeps_edits` do edited samples stay as they are.
///  3. With `plays_edits`, the edits between a step and the next are shown one after the other, each when the
///     previous picture is complete.
///
/// Cost: for a step forward, that of the changes in its entries; for a step back, a replay. Threads: none.
///
/// Smallest use:
///     LessonPresenter presenter({registry, editor, layers, settings, set_settings, look_at});
///     presenter.start(session, 0);
///     presenter.go_to(1);
///     while (presenter.is_playing()) presenter.advance(now, picture_is_complete);
///     presenter.end();
class LessonPresenter {
 public:
  struct Uses {
    LiveRegistry registry;
    Editor& editor;
    LayerStack& layers;
    std::function<ComputationSettings()> settings;
    std::function<void(const ComputationSettings&)> set_settings;
    std::function<void(const Box2&)> look_at;  ///< an empty box means everything
  };
  explicit LessonPresenter(Uses uses) : uses_(std::move(uses)) {}

  /// Ends a running presentation, and shows a step. Error: its samples are invalid; then no presentation is running.
  Expected<void> start(std::shared_ptr<const Session> session, std::size_t step);
  /// Also restores layers and settings.
  void end();
  bool is_running() const { return run_.has_value(); }

  // The following functions require a running presentation.
  const Lesson& lesson() const { return run_->session->lesson; }
  /// Title of the lesson, or else of its session.
  const std::string& title() const;
  std::size_t step() const { return run_->step; }
  std::size_t step_count() const { return lesson().steps.size(); }
  const std::string& caption() const { return lesson().steps[run_->step].caption; }

  /// Error: its samples are invalid; then the display stays.
  Expected<void> go_to(std::size_t step);
  /// Shows the next step; while edits are played, jumps to their end. Does nothing at the last step.
  Expected<void> go_on();
  /// Shows the previous step. Does nothing at the first step.
  Expected<void> go_back();

  /// True if the samples were edited since the step was shown, or are edited ones of an earlier step.
  bool is_edited() const;
  /// Restores the samples of the step.
  Expected<void> restore();
  bool keeps_edits() const { return keeps_edits_; }
  void set_keeps_edits(bool keeps) { keeps_edits_ = keeps; }

  bool plays_edits() const { return plays_edits_; }
  void set_plays_edits(bool plays) { plays_edits_ = plays; }
  bool is_playing() const { return run_ && run_->play_end != 0; }
  /// Seconds from `now` until the next edit is due; nothing while none is played.
  std::optional<double> next_due(double now) const;
  /// Call it once per frame; `may_step`: the picture is complete. Returns true if something has changed.
  bool advance(double now, bool may_step);

 private:
  struct Run {
    std::shared_ptr<const Session> session;
    LessonWalk walk;
    Editor::Aside aside;
    LayerConfiguration layers_before;
    ComputationSettings settings_before;
    std::size_t step = 0;
    std::size_t position = 0;    // timeline position of the present samples
    std::uint64_t revision = 0;  // document revision as the lesson left it
    SampleId next_sample{};      // the id of the next insertion, as the lesson left it
    BallId next_ball{};
    bool has_own = false;      // edited samples of an earlier step were kept
    std::size_t play_end = 0;  // end of the playback; 0: nothing is being played
    std::size_t edits_at_once = 1;
    double seconds_each = 0.0;
    double not_before = 0.0;
  };
  Expected<void> show(std::size_t step);
  void show_around(const LessonScene& scene);
  /// Undoes edits by hand.
  Expected<void> undo_edits();
  Expected<void> bring_document_to(std::size_t position);
  Expected<void> replay_to(std::size_t position);
  void begin_playing(std::size_t end);
  /// Performs the entries before `end`, but at most `most` that change the document.
  Expected<void> perform_edits(std::size_t end, std::size_t most);
  /// True if the next entry of the timeline refers to the same samples as when it was made.
  bool has_numbers_of_lesson() const;
  void note_shown();

  Uses uses_;
  std::optional<Run> run_;
  bool keeps_edits_ = false;
  bool plays_edits_ = true;
};

}  // namespace mes

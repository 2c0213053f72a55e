// SPDX-License-Identifier: GPL-3.0-or-later
// Presents the steps of a lesson in the editor, where they can be worked on, and puts everything back afterwards.
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

/// What it guarantees:
///  1. While it runs, the editor holds the samples of a step, to be edited like any others. What the editor held
///     before, with its history and its timeline, is put aside, and is there again, to the last bit, after `end`.
///  2. A step that is gone to shows the samples, layers, settings and view that `LessonWalk` gives, whatever was done
///     before; only with `keeps_edits` do samples that were edited stay as they are.
///  3. Where `plays_edits`, the edits between a step and the next are seen one after the other, each when the picture
///     of the one before is complete.
///
/// Cost: of a step forward what its entries change, of one back a replay. Threads: none.
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
    std::function<void(const Box2&)> look_at;  ///< empty: at everything
  };
  explicit LessonPresenter(Uses uses) : uses_(std::move(uses)) {}

  /// Ends what is running, and shows a step. Error: its samples make no sense; nothing runs then.
  Expected<void> start(std::shared_ptr<const Session> session, std::size_t step);
  /// Layers and settings are then as they were before, too.
  void end();
  bool is_running() const { return run_.has_value(); }

  // What follows is for one that is running.
  const Lesson& lesson() const { return run_->session->lesson; }
  /// Of the lesson, or else of its session.
  const std::string& title() const;
  std::size_t step() const { return run_->step; }
  std::size_t step_count() const { return lesson().steps.size(); }
  const std::string& caption() const { return lesson().steps[run_->step].caption; }

  /// Error: its samples make no sense; what is shown stays.
  Expected<void> go_to(std::size_t step);
  /// To the next step; while edits are played, to their end. At the last step nothing happens.
  Expected<void> go_on();
  /// To the step before. At the first step nothing happens.
  Expected<void> go_back();

  /// The samples were edited since the step was shown, or are those of an earlier step that were edited.
  bool is_edited() const;
  /// Gives the samples of the step back.
  Expected<void> restore();
  bool keeps_edits() const { return keeps_edits_; }
  void set_keeps_edits(bool keeps) { keeps_edits_ = keeps; }

  bool plays_edits() const { return plays_edits_; }
  void set_plays_edits(bool plays) { plays_edits_ = plays; }
  bool is_playing() const { return run_ && run_->play_end != 0; }
  /// When the next edit is due, in seconds from `now`; nothing while none is played.
  std::optional<double> next_due(double now) const;
  /// Once a frame; `may_step`: the picture is complete. True when something was changed.
  bool advance(double now, bool may_step);

 private:
  struct Run {
    std::shared_ptr<const Session> session;
    LessonWalk walk;
    Editor::Aside aside;
    LayerConfiguration layers_before;
    ComputationSettings settings_before;
    std::size_t step = 0;
    std::size_t position = 0;    // of the timeline, whose samples these are
    std::uint64_t revision = 0;  // of the document, as the lesson has it
    SampleId next_sample{};      // that an insertion would make, as the lesson has it
    BallId next_ball{};
    bool has_own = false;      // edited samples were kept at an earlier step
    std::size_t play_end = 0;  // where playing ends; 0: nothing is played
    std::size_t edits_at_once = 1;
    double seconds_each = 0.0;
    double not_before = 0.0;
  };
  Expected<void> show(std::size_t step);
  void show_around(const LessonScene& scene);
  /// Takes back what was edited by hand.
  Expected<void> undo_edits();
  Expected<void> bring_document_to(std::size_t position);
  Expected<void> replay_to(std::size_t position);
  void begin_playing(std::size_t end);
  /// Performs the entries before `end`, of those that change the document so many at most.
  Expected<void> perform_edits(std::size_t end, std::size_t most);
  /// The next entry of the timeline means the samples that it meant when it was made.
  bool has_numbers_of_lesson() const;
  void note_shown();

  Uses uses_;
  std::optional<Run> run_;
  bool keeps_edits_ = false;
  bool plays_edits_ = true;
};

}  // namespace mes

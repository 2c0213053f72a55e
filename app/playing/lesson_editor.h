// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a lesson from the display: marks moments as steps, orders them, and edits their captions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/editor.h"

namespace mes {

/// Guarantees: a marked step, presented at any later time, shows the samples, visible layers, settings and view of
/// the moment when it was marked. Changes can be taken back, in order, until another document is opened. Lessons keep
/// the bounds of core/document/timeline/lesson.h.
///
/// Cost: that of copying the lesson. Threads: none.
///
/// Smallest use:
///     LessonEditor lesson_editor(editor, [&] { return LessonEditor::Look{layers.configuration(), settings, view}; });
///     lesson_editor.mark();
///     lesson_editor.set_caption("# A crust");
class LessonEditor {
 public:
  /// The present layers, settings and view.
  struct Look {
    LayerConfiguration layers;
    ComputationSettings settings;
    Box2 view;
  };
  LessonEditor(Editor& editor, std::function<Look()> look) : editor_(editor), look_(std::move(look)) {}

  const Lesson& lesson() const { return editor_.lesson(); }
  /// The step being edited; nothing: none.
  std::optional<std::size_t> chosen();
  void choose(std::size_t step) { chosen_ = step; }

  bool is_full() const { return lesson().steps.size() >= kMostLessonSteps; }
  bool can_mark() const;
  /// Makes the present display a step after the chosen one, or the last one, and chooses it. Requires `can_mark`.
  void mark();
  /// A text that is being typed enters the lesson letter by letter, so that a crash loses none; all letters until
  /// `end_typing` are one change to take back.
  void type_title(const std::string& title);
  void end_typing() { typed_.reset(); }

  // The following functions refer to the chosen step.
  /// Replaces its display by the present one, and keeps its caption.
  void mark_again();
  void set_caption(const std::string& caption);
  void type_caption(const std::string& caption);
  /// Sets its duration in a video; 0: the time needed to read its caption.
  void set_seconds(double seconds);
  void remove();
  bool can_move(int places);
  void move(int places);

  bool can_take_back();
  void take_back();

 private:
  /// The present moment, without a caption.
  LessonStep moment();
  void change(Lesson next);
  void type(Lesson next);
  /// Adapts to another document, whose lesson has no steps to take back.
  void follow();

  Editor& editor_;
  std::function<Look()> look_;
  std::optional<std::size_t> chosen_;
  std::vector<Lesson> before_;   // the lessons that `take_back` restores, the last one first
  std::optional<Lesson> typed_;  // what the last letter made of the lesson
  std::uint64_t generation_ = 0;
};

}  // namespace mes

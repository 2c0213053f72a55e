// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a lesson of what is shown: marks moments as steps, puts them in order, writes their captions.
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

/// What it guarantees: a step that is marked, presented at any later time, shows the samples, the visible layers, the
/// settings and the view of the moment at which it was marked. Each change can be taken back, in order, until another
/// document is opened. Lessons keep the bounds of core/document/lesson.h.
///
/// Cost: that of copying the lesson. Threads: none.
///
/// Smallest use:
///     LessonDesk desk(editor, [&] { return LessonDesk::Look{layers.configuration(), settings, view}; });
///     desk.mark();
///     desk.set_caption("# A crust");
class LessonDesk {
 public:
  /// How things are looked at now.
  struct Look {
    LayerConfiguration layers;
    ComputationSettings settings;
    Box2 view;
  };
  LessonDesk(Editor& editor, std::function<Look()> look) : editor_(editor), look_(std::move(look)) {}

  const Lesson& lesson() const { return editor_.lesson(); }
  /// The step that is worked on; nothing: none.
  std::optional<std::size_t> chosen();
  void choose(std::size_t step) { chosen_ = step; }

  bool is_full() const { return lesson().steps.size() >= kMostLessonSteps; }
  bool can_mark() const;
  /// Makes what is shown now a step after the chosen one, or the last one, and chooses it. Where `can_mark`.
  void mark();
  void set_title(const std::string& title);

  // Of the chosen step.
  /// It shows what is shown now, under the caption that it has.
  void mark_again();
  void set_caption(const std::string& caption);
  /// How long it stays in a video; 0: as long as its caption needs to be read.
  void set_seconds(double seconds);
  void remove();
  bool can_move(int places);
  void move(int places);

  bool can_take_back();
  void take_back();

 private:
  /// The moment, without words.
  LessonStep moment();
  void change(Lesson next);
  /// Another document has another lesson, of which nothing is known here.
  void follow();

  Editor& editor_;
  std::function<Look()> look_;
  std::optional<std::size_t> chosen_;
  std::vector<Lesson> before_;  // what `take_back` gives, the last one first
  std::uint64_t generation_ = 0;
};

}  // namespace mes

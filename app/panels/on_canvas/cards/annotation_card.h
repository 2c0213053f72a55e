// SPDX-License-Identifier: GPL-3.0-or-later
// The card that edits the chosen annotation: its text, kind, size and colour.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/editing/tools/annotation_editor.h"
#include "app/ui/screen/gui.h"
#include "app/ui/widgets/wrapped_field.h"

namespace mes {

/// Every change is visible at once. Enter ends the writing, Ctrl+Enter begins another line; Esc reverts the text to
/// what it was when the field was entered. Threads: the window's.
class AnnotationCard {
 public:
  /// `beside`: the point to keep free, in screen coordinates. The card stays within `room`, given by its low and high
  /// corner.
  void draw(const Gui& gui, AnnotationEditor& annotations, ImVec2 beside, const ImVec2 (&room)[2],
            const std::function<void(const Error&)>& report);

 private:
  /// Returns true when the writing has ended.
  bool draw_words(const Gui& gui, Annotation& annotation, bool is_new);
  static void draw_look(const Gui& gui, Annotation& annotation);

  WrappedField words_;
  std::uint64_t choice_number_ = 0;
  ImVec2 at_{};  ///< fixed position while an annotation is chosen
};

}  // namespace mes

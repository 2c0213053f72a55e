// SPDX-License-Identifier: GPL-3.0-or-later
// The card on which the chosen annotation is written: its words, kind, size and colour.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/editing/annotation_desk.h"
#include "app/ui/gui.h"

namespace mes {

/// Every change shows at once. Enter ends writing, Ctrl+Enter begins another line; Esc takes back what was typed since
/// the field was entered. Threads: the window's.
class AnnotationCard {
 public:
  /// `beside`: what it is to leave free, in screen coordinates; it stays within `room`, low and high corner.
  void draw(const Gui& gui, AnnotationDesk& desk, ImVec2 beside, const ImVec2 (&room)[2],
            const std::function<void(const Error&)>& report);

 private:
  /// True when writing has ended.
  bool draw_words(const Gui& gui, Annotation& annotation, bool is_new);
  static void draw_look(const Gui& gui, Annotation& annotation);

  std::uint64_t choice_number_ = 0;
  ImVec2 at_{};  ///< where it stays while one is chosen
};

}  // namespace mes

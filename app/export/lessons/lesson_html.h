// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson as one self-contained HTML file: slides in a browser.
//
// Guarantees: the file contains everything it needs and requests nothing from the network, which a policy in its head
// also forbids; captions are escaped; without scripts all steps are visible, one below the other, and a printer gets
// one per page.
//
// Keys, also of clickers: Right, Down, Page Down, Space and Enter go forward, Left, Up, Page Up and Backspace go
// back, Home and End show the first and the last step, F fills the screen.
//
// Smallest use:
//     LessonHtml html({.title = "Crust", .steps = 2});
//     for (std::size_t i = 0; i < 2; ++i) html.add(*printer.page(i), i + 1);
//     const std::string bytes = std::move(html).file();
//
// Cost: that of the shapes. Threads: one at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/export/lessons/lesson_pages.h"
#include "core/base/error.h"

namespace mes {

struct LessonHtmlLook {
  std::string title{};
  std::size_t steps = 0;  ///< number of steps of the lesson
  double width = 960.0;   ///< width of a printed page, in points
  double height = 540.0;
  std::optional<Rgb> background = Rgb{255, 255, 255};
};

class LessonHtml {
 public:
  explicit LessonHtml(LessonHtmlLook look) : look_(std::move(look)) {}

  /// Adds the step with this number, from 1. Errors of the writers of figures; then nothing is added.
  Expected<void> add(const LessonPage& page, std::size_t number);
  std::string file() &&;

 private:
  LessonHtmlLook look_;
  std::string steps_;
};

}  // namespace mes

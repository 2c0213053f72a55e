// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson as the bytes of a PDF or HTML file, for the command line and the window.
//
// Smallest use:
//     const auto made = make_lesson_files(registry, session, {.steps = {0, 1}, .wants_pdf = true}, {});
//     if (made) write_file_atomically("lesson.pdf", made->pdf);
//
// Cost: one computation from scratch per step. Threads: none.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/export/lessons/lesson_pages.h"
#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

/// How the work on a lesson reports, and how it is stopped: with the error `cancelled`.
struct LessonWork {
  std::function<void(const std::string& task, double fraction)> show = [](const std::string&, double) {};
  std::function<void(const std::string& remark)> say = [](const std::string&) {};  ///< something was left out
  std::stop_token stop{};

  /// Reports that the work on step `k` of `count` begins; true if it must stop.
  bool begin_step(const std::string& thing, std::size_t k, std::size_t count) const;
};

struct LessonFilesRequest {
  LessonLook look{};
  std::vector<std::size_t> steps{};  ///< from 0, in order
  bool wants_pdf = false;
  bool wants_html = false;
  std::string session{};  ///< carried by the PDF (`packed_session`); empty: none
};

struct LessonFiles {
  std::string pdf{};  ///< empty if it was not wanted
  std::string html{};
};

/// Error: those of LessonPrinter and of the writers of figures.
Expected<LessonFiles> make_lesson_files(const Registry& registry, const Session& session,
                                        const LessonFilesRequest& request, const LessonWork& work);

/// The error of work on a lesson that was stopped.
Error lesson_was_cancelled();

}  // namespace mes

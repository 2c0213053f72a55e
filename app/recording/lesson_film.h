// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson as pictures and as a video, for the command line and the window.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/export/lessons/lesson_files.h"
#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {

struct LessonFilmRequest {
  LessonLook look{};  ///< its width and height follow from the size of the pictures
  int width = 1280;   ///< pixels
  int height = 720;
  std::vector<std::size_t> steps{};  ///< from 0, in order
  std::filesystem::path frames{};    ///< folder of the pictures; empty: they are not kept
  std::filesystem::path video{};     ///< .mp4 or .webm; empty: only the pictures
  std::string session{};             ///< in the manifest of pictures that are kept (`packed_session`); empty: none
};

/// Writes one picture per step, and a video in which each is shown for as long as its step lasts. Error: those of
/// LessonPrinter and `make_video`, and `cannot_write`, also if the folder has such pictures already.
Expected<void> write_lesson_film(const Registry& registry, const Session& session, const LessonFilmRequest& request,
                                 const LessonWork& work);

}  // namespace mes

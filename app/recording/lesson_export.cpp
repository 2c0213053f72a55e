// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/lesson_export.h"

#include <fmt/core.h>
#include <algorithm>
#include <new>
#include <numeric>

#include "app/export/lessons/carried.h"
#include "app/export/lessons/lesson_files.h"
#include "app/recording/lesson_film.h"
#include "app/recording/video.h"
#include "core/base/lower_case.h"
#include "core/io/files/atomic_file.h"
#include "core/io/session/session.h"

namespace mes {
namespace {

Expected<void> write_lesson(const Registry& registry, const Session& session, const std::filesystem::path& file,
                            const LessonWork& work) {
  const std::string extension = lower_case_extension(file);
  if (std::ranges::count(lesson_extensions(), extension) == 0)
    return std::unexpected(Error{ErrorCode::usage,
                                 extension.empty()
                                     ? "the name of a lesson's file must end in .pdf, .html, .mp4 or .webm"
                                     : "lessons are written as .pdf, .html, .mp4 or .webm, not as " + extension,
                                 file.string()});
  std::vector<std::size_t> steps(session.lesson.steps.size());
  std::iota(steps.begin(), steps.end(), std::size_t{0});
  if (is_video_name(file)) {
    if (auto good = check_video(file); !good) return good;
    return write_lesson_film(registry, session, {.steps = std::move(steps), .video = file}, work);
  }
  LessonFilesRequest request{
      .steps = std::move(steps), .wants_pdf = extension == ".pdf", .wants_html = extension == ".html"};
  if (request.wants_pdf) {
    if (auto packed = packed_session(session_for_lesson(session)))
      request.session = std::move(*packed);
    else
      work.say("the PDF carries no session: it would be too long");
  }
  auto made = make_lesson_files(registry, session, request, work);
  if (!made) return std::unexpected(made.error());
  if (work.stop.stop_requested()) return std::unexpected(lesson_was_cancelled());
  return write_file_atomically(file, request.wants_pdf ? made->pdf : made->html);
}

}  // namespace

const std::vector<std::string>& lesson_extensions() {
  static const std::vector<std::string> all{".pdf", ".html", ".mp4", ".webm"};
  return all;
}

void LessonExport::begin(std::shared_ptr<const Registry> registry, std::shared_ptr<const Session> session,
                         const std::filesystem::path& file) {
  file_ = file;
  stop_ = std::stop_source();
  progress_ = std::make_shared<std::atomic<double>>(0.0);
  job_.begin([registry = std::move(registry), session = std::move(session), file, progress = progress_,
              stop = stop_.get_token()](const std::stop_token&) -> Done {
    Done out{file, {}, {}};
    try {
      out.outcome = write_lesson(*registry, *session, file,
                                 {.show = [&](const std::string&, double fraction) { *progress = fraction; },
                                  .say = [&](const std::string& remark) { out.remarks.push_back(remark); },
                                  .stop = stop});
    } catch (const std::bad_alloc&) {
      out.outcome = std::unexpected(Error{ErrorCode::out_of_memory, "memory is not enough for this lesson"});
    }
    return out;
  });
}

}  // namespace mes

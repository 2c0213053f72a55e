// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/lesson_film.h"

#include <fmt/core.h>
#include <optional>
#include <system_error>
#include <utility>

#include "app/playing/lesson_walk.h"
#include "app/recording/frame_writer.h"
#include "app/recording/video.h"
#include "core/io/files/temporary.h"

namespace mes {
namespace {

std::unexpected<Error> cannot_write_frames(std::string text, const std::filesystem::path& folder) {
  return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), folder.string()});
}

Expected<void> prepare_lesson_frames(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return cannot_write_frames("cannot be made: " + error.message(), folder);
  if (std::filesystem::exists(folder / frame_name(1), error))
    return cannot_write_frames("there are frames already; name another folder", folder);
  return {};
}

Expected<void> write_lesson_frames(const Registry& registry, const std::filesystem::path& folder,
                                   const Session& session, const LessonFilmRequest& request, const LessonWork& work) {
  // The height of a slide, so that letters and lines have the sizes that they have there.
  constexpr double kHeight = 540.0;
  const double per_point = request.height / kHeight;
  LessonLook look = request.look;
  look.width = request.width / per_point;
  look.height = kHeight;
  auto printer = LessonPrinter::make(registry, session, look);
  if (!printer) return std::unexpected(printer.error());
  FrameWriter writer({folder, {request.width, request.height}});
  if (!request.session.empty()) writer.carry(request.session);
  double begin = 0.0;
  for (std::size_t k = 0; k < request.steps.size(); ++k) {
    if (work.begin_step("picture", k, request.steps.size())) return std::unexpected(lesson_was_cancelled());
    const auto page = printer->page(request.steps[k], work.stop);
    if (!page) return std::unexpected(page.error());
    for (const std::string& remark : page->remarks) work.say(remark);
    auto image = picture_of(*page, per_point);
    if (!image) return std::unexpected(image.error());
    if (!writer.push({std::move(*image), {page->name, page->document, begin}})) return writer.finish();
    begin += seconds_of(session.lesson.steps[request.steps[k]]);
  }
  return writer.finish();
}

}  // namespace

Expected<void> write_lesson_film(const Registry& registry, const Session& session, const LessonFilmRequest& request,
                                 const LessonWork& work) {
  constexpr double kFramesASecond = 25.0;
  std::optional<ScratchFolder> temporary;
  if (request.frames.empty()) {
    auto made = ScratchFolder::make();
    if (!made) return std::unexpected(made.error());
    temporary.emplace(std::move(*made));
  }
  const std::filesystem::path folder = temporary ? temporary->path() : request.frames;
  if (auto ready = prepare_lesson_frames(folder); !ready) return ready;
  if (auto done = write_lesson_frames(registry, folder, session, request, work); !done || request.video.empty())
    return done;
  work.show("making the video", 1.0);
  return make_video(
      folder, kFramesASecond, request.video, work.stop,
      {.pace = VideoPace::real_time, .last_seconds = seconds_of(session.lesson.steps[request.steps.back()])});
}

}  // namespace mes

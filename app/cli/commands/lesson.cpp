// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina lesson`: lists the steps of a lesson, or writes them on pages.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/picture.h"
#include "app/export/lessons/carried.h"
#include "app/export/lessons/lesson_captions.h"
#include "app/export/lessons/lesson_files.h"
#include "app/export/lessons/lesson_web.h"
#include "app/export/page_size.h"
#include "app/recording/lesson_film.h"
#include "app/recording/video.h"
#include "app/store/lessons.h"
#include "app/store/sample_shapes.h"
#include "core/base/counted.h"
#include "core/io/session/session.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

/// A lesson and its source files.
struct Chosen {
  std::shared_ptr<const Session> session;
  std::vector<SourceFile> sources{};
};

/// The lesson of a file, or the one of this name that comes with the program. Error: `usage` if the word is neither
/// such a name nor looks like a file name; `bad_input` if the file holds no lesson.
Expected<Chosen> lesson_of(const Registry& registry, const std::string& word) {
  std::error_code error;
  std::string file = word;
  if (word != "-" && !std::filesystem::exists(word, error)) {
    std::vector<std::string> names;
    const std::filesystem::path assets = find_assets({});
    for (const ShippedLesson& lesson : read_shipped_lessons(assets)) {
      names.push_back(lesson.name);
      if (lesson.name != word) continue;
      file = lesson.file.string();
      if (!file.empty()) break;
      auto made = session_of(registry, lesson, assets);
      if (!made) return std::unexpected(made.error());
      return Chosen{std::move(*made)};
    }
    const bool is_known = std::ranges::find(names, word) != names.end();
    if (!is_known && word.find_first_of("./") == std::string::npos && !names.empty()) {
      const std::vector<std::string_view> known(names.begin(), names.end());
      return usage_error("unknown lesson " + in_quotes(word) + "; did you mean " +
                         one_of(nearest_names(word, known)) + '?');
    }
  }
  auto input = read_input(registry, file, {});
  if (!input) return std::unexpected(input.error());
  if (!input->session)
    return std::unexpected(Error{ErrorCode::bad_input, "this is not a session but " + input->format, file});
  if (input->session->lesson.steps.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "this session has no lesson", file});
  return Chosen{std::move(input->session), std::move(input->sources)};
}

/// Reads step numbers from 1, e.g. "2-4" or "1,3-5"; the result has each once, in order.
Expected<std::vector<std::size_t>> parse_steps(const std::string& text, std::size_t count) {
  std::vector<bool> is_wanted(count, text.empty());
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view part = rest.substr(0, comma);
    if (comma + 1 == rest.size()) return usage_error("--steps ends in a comma");
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    const std::size_t dash = part.find('-');
    const auto first = parse_count(part.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : parse_count(part.substr(dash + 1));
    if (!first || !last || *first < 1 || *last < *first)
      return usage_error("--steps expects numbers from 1 and ranges, as in 2-4 or 1,3-5, not " + in_quotes(text));
    if (*last > count)
      return usage_error(fmt::format("--steps: the lesson has {}, and no step {}", counted(count, "step"), *last));
    std::fill(is_wanted.begin() + static_cast<std::ptrdiff_t>(*first - 1),
              is_wanted.begin() + static_cast<std::ptrdiff_t>(*last), true);
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i)
    if (is_wanted[i]) out.push_back(i);
  return out;
}

Expected<LessonLook> parse_look(const LessonRequest& request) {
  LessonLook look;
  const auto page = parse_page_size(request.figure_size);
  if (!page) return usage_error("--figure-size " + page.error().text);
  constexpr double kNarrowest = 0.2;
  look.width = page->width;
  look.height = page->height.value_or(page->width * 9.0 / 16.0);
  if (std::min(look.width, look.height) < kNarrowest * std::max(look.width, look.height))
    return usage_error("--figure-size: a page of a lesson is at most five times as long as wide, not " +
                       in_quotes(request.figure_size));
  constexpr double kLeastScale = 0.01;
  constexpr double kMostScale = 100.0;
  const auto scale = parse_number(request.scale);
  if (!scale || *scale < kLeastScale || *scale > kMostScale)
    return usage_error("--scale expects a number from 0.01 to 100, not " + in_quotes(request.scale));
  look.scale = *scale;
  const auto background = parse_background(request.background);
  if (!background) return std::unexpected(background.error());
  look.background = *background;
  look.legend = legend_scope(request.with_legend, request.with_key);
  look.marks = request.marks;
  look.with_annotations = request.with_annotations;
  return look;
}

std::string listed(const Session& session, const std::vector<std::size_t>& steps) {
  std::string out;
  for (const std::size_t i : steps) {
    const LessonStep& step = session.lesson.steps[i];
    out += fmt::format("{:>3}  {:>5}  {}\n", i + 1, fmt::format("{:.4g} s", seconds_of(step)),
                       printable(name_of(caption_text(step.caption))));
    while (out.ends_with(" \n")) out.erase(out.size() - 2, 1);
  }
  return out;
}

struct Output {
  std::string file;
  std::string bytes;
};

/// The outputs that consist of one file each.
std::vector<std::string> files_of(const LessonRequest& request) {
  std::vector<std::string> out;
  for (const std::string& file : {request.pdf, request.html, request.vtt})
    if (!file.empty()) out.push_back(file);
  return out;
}

Expected<void> check_outputs(const LessonRequest& request) {
  const std::vector<std::string> files = files_of(request);
  if (!request.video.empty()) {
    if (!is_video_name(request.video)) return usage_error("the name of the video must end in .mp4 or .webm");
    if (auto good = check_video(request.video); !good) return good;
  }
  if (request.pdf == "-" && ::isatty(STDOUT_FILENO) != 0)
    return usage_error("a PDF cannot be printed on a terminal; name a file");
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (std::find(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(i), files[i]) !=
        files.begin() + static_cast<std::ptrdiff_t>(i))
      return usage_error("two outputs are named " + in_quotes(files[i]));
    if (auto good = check_output(files[i]); !good) return good;
  }
  return {};
}

Expected<PictureSize> parse_frame_size(const LessonRequest& request) {
  const auto size = parse_size(request.size);
  if (!size) return size;
  if (size->width > 5 * size->height || size->height > 5 * size->width)
    return usage_error("--size: a picture of a lesson is at most five times as long as wide, not " +
                       in_quotes(request.size));
  return size;
}

/// `carrier`: what is to hold the session, for the message if it is too long.
std::string packed_lesson(const Session& session, std::string_view carrier) {
  auto packed = packed_session(session_for_lesson(session));
  if (!packed) say(fmt::format("{} no session: it would be too long", carrier));
  return std::move(packed).value_or("");
}

LessonWork work_on(Progress& progress) {
  return {.show = [&progress](const std::string& task, double fraction) { progress.show(task, fraction); },
          .say = [](const std::string& remark) { say(remark); }};
}

Expected<void> write_film(const Registry& registry, const LessonRequest& request, const Session& session,
                          const std::vector<std::size_t>& steps, const LessonLook& look, const PictureSize& size) {
  LessonFilmRequest film{.look = look,
                         .width = size.width,
                         .height = size.height,
                         .steps = steps,
                         .frames = request.frames,
                         .video = request.video};
  if (request.with_source && !request.frames.empty()) film.session = packed_lesson(session, "the frames carry");
  Progress progress;
  return write_lesson_film(registry, session, film, work_on(progress));
}

/// Makes everything before anything is written.
Expected<std::vector<Output>> make_outputs(const Registry& registry, const LessonRequest& request,
                                           const Session& session, const std::vector<std::size_t>& steps,
                                           const LessonLook& look) {
  std::vector<Output> out;
  if (!request.vtt.empty()) out.push_back({request.vtt, web_vtt_of(session.lesson, steps)});
  LessonFilesRequest files{
      .look = look, .steps = steps, .wants_pdf = !request.pdf.empty(), .wants_html = !request.html.empty()};
  if (!files.wants_pdf && !files.wants_html) return out;
  if (request.with_source && files.wants_pdf) files.session = packed_lesson(session, "the PDF carries");
  Progress progress;
  auto made = make_lesson_files(registry, session, files, work_on(progress));
  if (!made) return std::unexpected(made.error());
  if (files.wants_pdf) out.push_back({request.pdf, std::move(made->pdf)});
  if (files.wants_html) out.push_back({request.html, std::move(made->html)});
  return out;
}

}  // namespace

Expected<void> run_lesson(const Registry& registry, const LessonRequest& request, Interruption& interruption) {
  const auto look = parse_look(request);
  if (!look) return std::unexpected(look.error());
  const auto size = parse_frame_size(request);
  if (!size) return std::unexpected(size.error());
  if (auto good = check_outputs(request); !good) return good;
  const auto lesson = lesson_of(registry, request.file);
  if (!lesson) return std::unexpected(lesson.error());
  const Session& session = *lesson->session;
  const auto steps = parse_steps(request.steps, session.lesson.steps.size());
  if (!steps) return std::unexpected(steps.error());
  const bool has_frames = !request.frames.empty() || !request.video.empty();
  if (files_of(request).empty() && !has_frames && request.web.empty())
    return write_output({}, listed(session, *steps), interruption);
  const auto outputs = make_outputs(registry, request, session, *steps, *look);
  if (!outputs) return std::unexpected(outputs.error());
  if (!request.web.empty())
    if (auto done = write_lesson_page(find_web_page(find_assets({})), request.web, session, request.force); !done)
      return done;
  if (has_frames)
    if (auto done = write_film(registry, request, session, *steps, *look, *size); !done) return done;
  for (const Output& output : *outputs)
    if (auto done = write_output(output.file, output.bytes, interruption, {lesson->sources, request.force}); !done)
      return done;
  return {};
}

}  // namespace mes::cli

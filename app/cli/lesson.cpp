// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina lesson`: the steps of a lesson, listed or on pages.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/picture.h"
#include "app/cli/progress.h"
#include "app/cli/requests.h"
#include "app/export/carried.h"
#include "app/export/lesson_pages.h"
#include "app/export/page_size.h"
#include "app/store/lessons.h"
#include "app/store/sample_shapes.h"
#include "core/io/carried_session.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

/// The file of a lesson that comes with the program, or the word itself. Error: `usage` for a word that is neither such
/// a lesson nor a file, and cannot be meant for one.
Expected<std::string> file_of(const std::string& word) {
  std::error_code error;
  if (word == "-" || std::filesystem::exists(word, error)) return word;
  std::vector<std::string> names;
  for (const ShippedLesson& lesson : read_shipped_lessons(find_assets({}))) {
    if (lesson.name == word) return lesson.file.string();
    names.push_back(lesson.name);
  }
  if (word.find_first_of("./") != std::string::npos || names.empty()) return word;
  const std::vector<std::string_view> known(names.begin(), names.end());
  return usage_error("unknown lesson " + in_quotes(word) + "; did you mean " + one_of(nearest_names(word, known)) +
                     '?');
}

/// Steps from 1, each once and in their order: "2-4", "1,3-5".
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
      return usage_error(
          fmt::format("--steps: the lesson has {} {}, and no step {}", count, count == 1 ? "step" : "steps", *last));
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

/// Everything is made before anything is written.
Expected<std::vector<Output>> make_outputs(const LessonRequest& request, const Session& session,
                                           const std::vector<std::size_t>& steps, const LessonLook& look) {
  auto printer = LessonPrinter::make(session, look);
  if (!printer) return std::unexpected(printer.error());
  figure::BookInfo info = printer->info();
  if (request.with_source) {
    auto packed = packed_session(session_for_lesson(session));
    if (!packed) say("the PDF carries no session: it would be too long");
    info.session = std::move(packed).value_or("");
  }
  figure::PdfBook book(std::move(info));
  Progress progress;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    progress.show(fmt::format("step {} of {}", k + 1, steps.size()),
                  static_cast<double>(k) / static_cast<double>(steps.size()));
    const auto page = printer->page(steps[k]);
    if (!page) return std::unexpected(page.error());
    for (const std::string& remark : page->remarks) say(remark);
    book.add(sheet_of(*page));
  }
  std::vector<Output> out;
  out.push_back({request.pdf, std::move(book).file()});
  return out;
}

}  // namespace

Expected<void> run_lesson(const LessonRequest& request, Interruption& interruption) {
  const auto look = parse_look(request);
  if (!look) return std::unexpected(look.error());
  if (!request.pdf.empty()) {
    if (is_standard_output(request.pdf) && ::isatty(STDOUT_FILENO) != 0)
      return usage_error("slides cannot be printed on a terminal; name a file");
    if (auto good = check_output(request.pdf); !good) return good;
  }
  const auto file = file_of(request.file);
  if (!file) return std::unexpected(file.error());
  const auto input = read_input(*file, {});
  if (!input) return std::unexpected(input.error());
  if (!input->session)
    return std::unexpected(Error{ErrorCode::bad_input, "this is not a session but " + input->format, *file});
  const Session& session = *input->session;
  if (session.lesson.steps.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "this session has no lesson", *file});
  const auto steps = parse_steps(request.steps, session.lesson.steps.size());
  if (!steps) return std::unexpected(steps.error());
  if (request.pdf.empty()) return write_output({}, listed(session, *steps), interruption);
  const auto outputs = make_outputs(request, session, *steps, *look);
  if (!outputs) return std::unexpected(outputs.error());
  for (const Output& output : *outputs)
    if (auto done = write_output(output.file, output.bytes, interruption, {input->sources, request.force}); !done)
      return done;
  return {};
}

}  // namespace mes::cli

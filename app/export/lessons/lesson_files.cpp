// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/lesson_files.h"

#include <fmt/core.h>
#include <utility>

#include "app/export/lessons/lesson_html.h"

namespace mes {

Error lesson_was_cancelled() {
  return {ErrorCode::cancelled, "the export of the lesson was cancelled"};
}

bool LessonWork::begin_step(const std::string& thing, std::size_t k, std::size_t count) const {
  show(fmt::format("{} {} of {}", thing, k + 1, count), static_cast<double>(k) / static_cast<double>(count));
  return stop.stop_requested();
}

Expected<LessonFiles> make_lesson_files(const Registry& registry, const Session& session,
                                        const LessonFilesRequest& request, const LessonWork& work) {
  const LessonLook& look = request.look;
  auto printer = LessonPrinter::make(registry, session, look);
  if (!printer) return std::unexpected(printer.error());
  figure::BookInfo info = printer->info();
  info.session = request.session;
  figure::PdfBook book(std::move(info));
  LessonHtml html({printer->title(), session.lesson.steps.size(), look.width, look.height, look.background});
  for (std::size_t k = 0; k < request.steps.size(); ++k) {
    if (work.begin_step("step", k, request.steps.size())) return std::unexpected(lesson_was_cancelled());
    const auto page = printer->page(request.steps[k], work.stop);
    if (!page) return std::unexpected(page.error());
    for (const std::string& remark : page->remarks) work.say(remark);
    if (request.wants_pdf) book.add(sheet_of(*page));
    if (request.wants_html)
      if (auto added = html.add(*page, request.steps[k] + 1); !added) return std::unexpected(added.error());
  }
  LessonFiles out;
  if (request.wants_pdf) out.pdf = std::move(book).file();
  if (request.wants_html) out.html = std::move(html).file();
  return out;
}

}  // namespace mes

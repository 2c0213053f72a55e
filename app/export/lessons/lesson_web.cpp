// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/lesson_web.h"

#include <fmt/core.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include "app/export/lessons/carried.h"
#include "app/picture/paper/caption_text.h"
#include "app/picture/paper/rich_text.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/read_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kStart = "index.html";
constexpr std::string_view kLesson = "lesson.json";
constexpr std::string_view kProgram = "mesecina.wasm";

Expected<void> make_folder(const fs::path& folder, bool force) {
  std::error_code error;
  const auto refuse = [&](std::string text) {
    return std::unexpected(Error{ErrorCode::cannot_write, std::move(text), folder.string()});
  };
  fs::create_directories(folder, error);
  if (error) return refuse(error.message());
  const bool is_empty = fs::is_empty(folder, error);
  if (error) return refuse(error.message());
  if (!is_empty && !fs::exists(folder / kProgram, error) && !force)
    return refuse("this folder holds other files; --force writes into it");
  return {};
}

/// The page with the name of the lesson in its head.
std::string page_for_lesson(std::string page, const std::string& title) {
  constexpr std::string_view kTitle = "<title>Mesecina</title>";
  if (const std::size_t at = page.find(kTitle); at != std::string::npos)
    page.replace(at, kTitle.size(),
                 fmt::format("<title>{}</title>\n<meta name=\"lesson\" content=\"{}\">", title, kLesson));
  return page;
}

}  // namespace

fs::path find_web_page(const fs::path& assets) {
  std::error_code error;
  const char* const given = std::getenv("MESECINA_WEB");
  for (const fs::path& candidate :
       {fs::path(given != nullptr ? given : ""), assets / "web", assets / ".." / "build" / "web"})
    if (!candidate.empty() && fs::is_regular_file(candidate / kProgram, error)) return candidate;
  return {};
}

Expected<void> write_lesson_page(const fs::path& page, const fs::path& folder, const Session& session, bool force) {
  if (page.empty())
    return std::unexpected(Error{ErrorCode::cannot_compute,
                                 "the page for browsers is not here; scripts/web.sh makes it, and MESECINA_WEB names "
                                 "its folder"});
  const auto start = read_regular_file(page / kStart);
  if (!start) return std::unexpected(start.error());
  if (auto good = make_folder(folder, force); !good) return good;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(page, error)) {
    if (!entry.is_regular_file(error) || entry.path().filename() == kStart) continue;
    const fs::path target = folder / entry.path().filename();
    fs::copy_file(entry.path(), target, fs::copy_options::overwrite_existing, error);
    if (error) return std::unexpected(Error{ErrorCode::cannot_write, error.message(), target.string()});
  }
  if (auto done = write_file_atomically(folder / kLesson, write_session(session_for_lesson(session))); !done)
    return done;
  const std::string& title = session.lesson.title.empty() ? session.title : session.lesson.title;
  return write_file_atomically(folder / kStart, page_for_lesson(*start, escaped_html(readable_text(title))));
}

}  // namespace mes

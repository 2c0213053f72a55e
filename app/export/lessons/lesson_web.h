// SPDX-License-Identifier: GPL-3.0-or-later
// The page on which a browser presents a lesson, live (docs/features/web.md).
#pragma once

#include <filesystem>

#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {

/// The first existing one of $MESECINA_WEB, `web` in the assets (if installed) and `../build/web` beside them (where
/// scripts/web.sh makes it); empty if there is none.
std::filesystem::path find_web_page(const std::filesystem::path& assets);

/// Copies the page into the folder, with the lesson as `lesson.json` and an `index.html` that presents it. Errors:
/// `cannot_compute` if `page` is empty; `cannot_write`, also if the folder holds something else than such a page and
/// `force` is false.
Expected<void> write_lesson_page(const std::filesystem::path& page, const std::filesystem::path& folder,
                                 const Session& session, bool force);

}  // namespace mes

// SPDX-License-Identifier: GPL-3.0-or-later
// Makes frames and a video of a session.
#pragma once

#include <string>

#include "app/cli/requests/requests.h"
#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {
class Registry;
}  // namespace mes

namespace mes::cli {

/// Rejects invalid options, and a video that cannot be made or written, before the work begins.
Expected<void> check(const FilmRequest& request);

/// Error: `cannot_write` also if the folder has such frames already. `name` stands for the session in messages.
Expected<void> make_film(const Registry& registry, const Session& session, const std::string& name,
                         const FilmRequest& request);

}  // namespace mes::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina demo`: the video of the paper, computed again.
#include "app/cli/commands/commands.h"
#include "app/cli/commands/film.h"
#include "app/store/lessons.h"

namespace mes::cli {

Expected<void> run_demo(const Registry& registry, const DemoRequest& request, Interruption& /*interruption*/) {
  FilmRequest film = request.film;
  if (film.frames.empty() && film.video.empty()) film.frames = "mesecina-demo";
  if (auto good = check(film); !good) return good;
  const auto session = demo_of(registry, read_sample_shapes(find_assets({})));
  if (!session) return std::unexpected(session.error());
  return make_film(registry, *session, "demo", film);
}

}  // namespace mes::cli

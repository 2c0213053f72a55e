// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina demo`: the paper's video, computed anew.
#include "app/model/demo.h"

#include "app/cli/requests.h"
#include "app/store/sample_shapes.h"
#include "core/io/format.h"

namespace mes::cli {

Expected<void> run_demo(const DemoRequest& request, Interruption& /*interruption*/) {
  FilmRequest film = request.film;
  if (film.frames.empty() && film.video.empty()) film.frames = "mesecina-demo";
  if (auto good = check(film); !good) return good;
  const auto shapes = read_sample_shapes(find_assets({}));
  if (shapes.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "the sample shapes that come with the program are missing"});
  const auto shape = read_sample_file(shapes.front().file);
  if (!shape) return std::unexpected(shape.error());
  const auto session = demo_session(shape->data);
  if (!session) return std::unexpected(session.error());
  return make_film(*session, "demo", film);
}

}  // namespace mes::cli

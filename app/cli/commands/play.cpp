// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina play`: plays the timeline of a session step by step.
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands/commands.h"
#include "app/cli/commands/film.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/input.h"
#include "app/playing/player.h"
#include "core/draw/layer_mirror.h"
#include "core/graph/registry.h"
#include "core/io/session/json_text.h"

namespace mes::cli {
namespace {

Expected<std::shared_ptr<const Session>> read(const Registry& registry, const std::string& file) {
  auto loaded = read_input(registry, file, {});
  if (!loaded) return std::unexpected(loaded.error());
  if (!loaded->session)
    return std::unexpected(Error{ErrorCode::bad_input, "this is not a session but " + loaded->format, file});
  return loaded->session;
}

}  // namespace

Expected<void> run_play(const Registry& registry, const PlayRequest& request, Interruption& interruption) {
  if (auto good = check(request.film); !good) return good;
  const auto session = read(registry, request.session);
  if (!session) return std::unexpected(session.error());
  if (!request.film.frames.empty() || !request.film.video.empty())
    return make_film(registry, **session, request.session, request.film);
  LayerMirror mirror;
  Player player(registry, **session, [&mirror](const FramePatch& patch) { mirror.apply(patch); });
  Progress progress;
  std::string out;
  const std::size_t count = player.steps().size();
  for (std::size_t i = 0; i < count; ++i) {
    const PlayStep& step = player.steps()[i];
    progress.show(step.what, static_cast<double>(i) / static_cast<double>(count));
    if (auto done = player.apply(step); !done) {
      done.error().file = request.session;
      return done;
    }
    nlohmann::ordered_json line = {{"frame", i + 1}, {"what", step.what}};
    if (const std::string failure = player.complete(); !failure.empty()) line["failed"] = failure;
    line["document"] = fmt::format("{:016x}", player.document().digest());
    LayerDigest whole;
    nlohmann::ordered_json digests = nlohmann::ordered_json::object();
    for (const LayerIndex layer : player.layers().visible_layers()) {
      const std::string_view id = registry.layers()[layer].id;
      const LayerDigest digest = mirror.digest(layer);
      digests[std::string(id)] = digest.text();
      whole += named(id, digest);
    }
    line["layers"] = whole.text();
    line["digests"] = std::move(digests);
    out += json_text(line) + '\n';
  }
  return write_output("", out, interruption);
}

}  // namespace mes::cli
